#include "renderer/backend/gl/gl_functions.h"

#include <algorithm>

namespace rushlight {
namespace {

/// GL_MAX_LABEL_LENGTH is at least 256, its terminator included.
constexpr size_t kMaxLabel = 255;

tl::unexpected<Error> noContext(std::string message) {
    return fail("OpenGL", std::move(message), ErrorKind::noContext);
}

Result<void> checkVersion(const GlFunctions& gl) {
    const GLubyte* text = gl.GetString(GL_VERSION);
    if (!text) return noContext("No OpenGL context is current on this thread.");
    GLint major = 0, minor = 0;
    gl.GetIntegerv(GL_MAJOR_VERSION, &major);
    gl.GetIntegerv(GL_MINOR_VERSION, &minor);
    if (major * 10 + minor >= 45) return {};
    return noContext("OpenGL 4.5 is needed, but the context is " + std::to_string(major) + "." +
                     std::to_string(minor) + " (" + reinterpret_cast<const char*>(text) + ").");
}

}  // namespace

Result<void> GlFunctions::load(GlLoad loader) {
    if (!loader) return noContext("A loader of OpenGL functions is needed, but it is null.");
    // The version first: an old context is better named by its version than by a missing function.
    const bool hasStrings = GetString.load(loader, "glGetString", &calls);
    if (!hasStrings || !GetIntegerv.load(loader, "glGetIntegerv", &calls))
        return noContext(std::string("The loader does not know ") +
                         (hasStrings ? "glGetIntegerv" : "glGetString") +
                         "; is a context current?");
    if (Result<void> version = checkVersion(*this); !version) return version;
    std::string missing;
#define RL_GL_LOAD(name, type)                  \
    if (!name.load(loader, "gl" #name, &calls)) \
        missing += missing.empty() ? "gl" #name : ", gl" #name;
    RL_GL_FUNCTIONS(RL_GL_LOAD)
#undef RL_GL_LOAD
    if (missing.empty()) return {};
    return noContext("The OpenGL context lacks functions that are needed: " + missing + ".");
}

GLenum GlFunctions::resetStatus() const {
    if (reset_ == GL_NO_ERROR) reset_ = GetGraphicsResetStatus();
    return reset_;
}

void GlFunctions::label(GLenum kind, GLuint object, std::string_view text) const {
    if (text.empty()) return;
    ObjectLabel(kind, object, GLsizei(std::min(text.size(), kMaxLabel)), text.data());
}

}  // namespace rushlight

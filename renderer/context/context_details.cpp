#include "renderer/context/context_details.h"

#include "engine/core/check.h"

#include <GL/glcorearb.h>

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace rushlight {
namespace {

template <class F>
F load(GlLoader loader, const char* name) {
    return reinterpret_cast<F>(loader(name));
}

/// The few queries that describing a context takes.
struct Queries {
    PFNGLGETSTRINGPROC getString;
    PFNGLGETSTRINGIPROC getStringi;
    PFNGLGETINTEGERVPROC getIntegerv;
    PFNGLGETQUERYIVPROC getQueryiv;

    explicit Queries(GlLoader loader)
        : getString(load<PFNGLGETSTRINGPROC>(loader, "glGetString")),
          getStringi(load<PFNGLGETSTRINGIPROC>(loader, "glGetStringi")),
          getIntegerv(load<PFNGLGETINTEGERVPROC>(loader, "glGetIntegerv")),
          getQueryiv(load<PFNGLGETQUERYIVPROC>(loader, "glGetQueryiv")) {}

    bool complete() const { return getString && getStringi && getIntegerv && getQueryiv; }

    GLint integer(GLenum name) const {
        GLint value = 0;
        getIntegerv(name, &value);
        return value;
    }

    std::string text(GLenum name) const {
        const GLubyte* value = getString(name);
        return value ? reinterpret_cast<const char*>(value) : "";
    }

    std::vector<std::string_view> extensions() const {
        std::vector<std::string_view> names(size_t(integer(GL_NUM_EXTENSIONS)));
        for (size_t i = 0; i < names.size(); ++i)
            names[i] = reinterpret_cast<const char*>(getStringi(GL_EXTENSIONS, GLuint(i)));
        return names;
    }
};

/// Absent when none of `names` is there (an extension and its ARB or core-suffix twin).
struct WantedExtension {
    std::initializer_list<const char*> names;
    const char* reduced;
};

const WantedExtension kWantedExtensions[] = {
    {{"GL_ARB_bindless_texture"}, "textures are grouped into arrays of one size instead."},
    {{"GL_ARB_texture_filter_anisotropic", "GL_EXT_texture_filter_anisotropic"},
     "textures seen at a grazing angle are blurred by trilinear filtering."},
    {{"GL_ARB_indirect_parameters"}, "the number of draws always comes from the CPU."},
    {{"GL_KHR_parallel_shader_compile", "GL_ARB_parallel_shader_compile"},
     "shaders are compiled one after the other, which makes the first frame slower."},
    {{"GL_KHR_shader_subgroup"}, "reductions in shaders go through shared memory."},
};

struct WantedLimit {
    GLenum name;
    const char* spelled;
    GLint wanted;
    const char* reduced;
};

const WantedLimit kWantedLimits[] = {
    {GL_MAX_TEXTURE_SIZE, "GL_MAX_TEXTURE_SIZE", 16384, "larger images are refused."},
    {GL_MAX_ARRAY_TEXTURE_LAYERS, "GL_MAX_ARRAY_TEXTURE_LAYERS", 2048,
     "fewer images share one texture array."},
    {GL_MAX_TEXTURE_IMAGE_UNITS, "GL_MAX_TEXTURE_IMAGE_UNITS", 32,
     "fewer texture arrays are visible to one draw."},
    {GL_NUM_PROGRAM_BINARY_FORMATS, "GL_NUM_PROGRAM_BINARY_FORMATS", 1,
     "compiled shaders are not kept on disk, so each start compiles them again."},
};

void listExtensions(const Queries& gl, std::vector<std::string>& missing) {
    const auto present = gl.extensions();
    const auto has = [&](const char* name) {
        return std::ranges::find(present, name) != present.end();
    };
    for (const WantedExtension& wanted : kWantedExtensions)
        if (std::ranges::none_of(wanted.names, has))
            missing.push_back(std::string(*wanted.names.begin()) + " is absent: " + wanted.reduced);
}

void listLimits(const Queries& gl, std::vector<std::string>& missing) {
    for (const WantedLimit& limit : kWantedLimits)
        if (const GLint value = gl.integer(limit.name); value < limit.wanted)
            missing.push_back(std::string(limit.spelled) + " is " + std::to_string(value) +
                              ", less than " + std::to_string(limit.wanted) + ": " + limit.reduced);
}

void listTimers(const Queries& gl, std::vector<std::string>& missing) {
    GLint bits = 0;
    gl.getQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
    if (bits == 0) missing.push_back("GPU timestamps have 0 bits: GPU times are reported as 0.");
}

}  // namespace

std::string versionProblem(GlLoader loader) {
    const Queries gl(loader);
    if (!gl.complete()) return "The context's loader does not know glGetString and its kin.";
    const GLint major = gl.integer(GL_MAJOR_VERSION);
    const GLint minor = gl.integer(GL_MINOR_VERSION);
    if (major > 4 || (major == 4 && minor >= 5)) return {};
    return "The driver (" + gl.text(GL_RENDERER) + ") gives OpenGL " + std::to_string(major) + "." +
           std::to_string(minor) + "; 4.5 is needed.";
}

void describeContext(GlLoader loader, ContextAttempt& attempt) {
    const Queries gl(loader);
    RL_CHECK(gl.complete(), "createContext has refused a context without these functions");
    attempt.glVendor = gl.text(GL_VENDOR);
    attempt.glRenderer = gl.text(GL_RENDERER);
    attempt.glVersion = gl.text(GL_VERSION);
    attempt.glslVersion = gl.text(GL_SHADING_LANGUAGE_VERSION);
    listExtensions(gl, attempt.missing);
    listLimits(gl, attempt.missing);
    listTimers(gl, attempt.missing);
}

}  // namespace rushlight

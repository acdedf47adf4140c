#include "renderer/backend/gl/gl_debug.h"

#include <utility>

namespace rushlight {
namespace {

constexpr size_t kMaxMessages = 256;

}  // namespace

GlDebug::GlDebug(const GlFunctions& gl, bool enabled) : gl_(gl), enabled_(enabled) {
    if (!enabled_) return;
    gl_.Enable(GL_DEBUG_OUTPUT);
    gl_.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    gl_.DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    gl_.DebugMessageCallback(&GlDebug::receive, this);
}

GlDebug::~GlDebug() {
    if (!enabled_) return;
    // Another device or the host may have taken the context's one callback over.
    void* user = nullptr;
    gl_.GetPointerv(GL_DEBUG_CALLBACK_USER_PARAM, &user);
    if (user == this) gl_.DebugMessageCallback(nullptr, nullptr);
}

std::vector<std::string> GlDebug::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(messages_, {});
}

void APIENTRY GlDebug::receive(GLenum, GLenum, GLuint, GLenum severity, GLsizei length,
                               const GLchar* message, const void* user) {
    if (severity != GL_DEBUG_SEVERITY_HIGH && severity != GL_DEBUG_SEVERITY_MEDIUM) return;
    auto* self = static_cast<GlDebug*>(const_cast<void*>(user));
    const std::lock_guard lock(self->mutex_);
    if (self->messages_.size() < kMaxMessages)
        self->messages_.emplace_back(message, size_t(length));
}

}  // namespace rushlight

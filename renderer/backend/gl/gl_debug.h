#pragma once
// GL debug messages (GL_KHR_debug) of medium severity and up, kept until they are taken.

#include "renderer/backend/gl/gl_functions.h"

#include <mutex>
#include <string>
#include <vector>

namespace rushlight {

class GlDebug {
public:
    GlDebug(const GlFunctions& gl, bool enabled);
    ~GlDebug();
    GlDebug(const GlDebug&) = delete;
    GlDebug& operator=(const GlDebug&) = delete;

    std::vector<std::string> take();

private:
    static void APIENTRY receive(GLenum source, GLenum type, GLuint id, GLenum severity,
                                 GLsizei length, const GLchar* message, const void* user);

    const GlFunctions& gl_;
    bool enabled_;
    std::mutex mutex_;  ///< a driver may call from a thread of its own
    std::vector<std::string> messages_;
};

}  // namespace rushlight

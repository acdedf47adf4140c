#pragma once
// What a host brings: a GL context of its own, a program and a vertex array of its own, and bad
// manners.

#include <EGL/egl.h>
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

#include <cstdint>
#include <string>
#include <vector>

namespace host {

using Pixels = std::vector<uint8_t>;  ///< RGBA, rows from the bottom

/// An EGL context with no surface, current, with synchronous debug output that is collected.
class Context {
public:
    Context();
    ~Context();
    bool valid() const { return context_ != EGL_NO_CONTEXT; }
    static void* load(const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); }
    std::vector<std::string> messages;  ///< of severity medium and high

private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

/// A framebuffer with a colour and a depth attachment.
struct Canvas {
    Canvas(uint32_t width, uint32_t height);
    ~Canvas();
    Pixels read() const;
    GLuint framebuffer = 0, color = 0, depth = 0;
    GLsizei width, height;
};

/// A magenta triangle in the lower left quarter, drawn with nothing but the state that it sets.
class Triangle {
public:
    Triangle();
    ~Triangle();
    void draw(const Canvas&) const;

private:
    GLuint program_ = 0, vertexArray_ = 0, buffer_ = 0;
};

/// Objects bound and switches set that would spoil a frame which relies on what it finds.
class BadManners {
public:
    BadManners();
    ~BadManners();
    void misbehave() const;
    /// Sets back what the renderer does not promise to reset, so that the host's own drawing is as
    /// before.
    static void behave();
    /// Sets everything back as a new context has it.
    static void recover();

private:
    GLuint buffer_ = 0, texture_ = 0, sampler_ = 0, framebuffer_ = 0, vertexArray_ = 0;
};

/// Sentences about state that is not as renderer/renderer.h promises after a frame.
std::vector<std::string> brokenPromises();

}  // namespace host

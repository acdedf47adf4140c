#include "tests/embed/host_gl.h"

#include <EGL/eglext.h>

namespace host {
namespace {

void APIENTRY collect(GLenum, GLenum, GLuint, GLenum severity, GLsizei length, const GLchar* text,
                      const void* user) {
    if (severity == GL_DEBUG_SEVERITY_HIGH || severity == GL_DEBUG_SEVERITY_MEDIUM)
        static_cast<Context*>(const_cast<void*>(user))->messages.emplace_back(text, size_t(length));
}

GLuint compile(GLuint program, GLenum stage, const char* source) {
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    return shader;
}

}  // namespace

Context::Context() {
    display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (!display_ || !eglInitialize(display_, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
        return;
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG,
                                 EGL_TRUE,
                                 EGL_NONE};
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (!context_ || !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(collect, this);
}

Context::~Context() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_) eglDestroyContext(display_, context_);
}

Canvas::Canvas(uint32_t w, uint32_t h) : width(GLsizei(w)), height(GLsizei(h)) {
    glCreateTextures(GL_TEXTURE_2D, 1, &color);
    glTextureStorage2D(color, 1, GL_SRGB8_ALPHA8, width, height);  // so that GL_FRAMEBUFFER_SRGB
                                                                   // counts
    glCreateRenderbuffers(1, &depth);
    glNamedRenderbufferStorage(depth, GL_DEPTH24_STENCIL8, width, height);
    glCreateFramebuffers(1, &framebuffer);
    glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, color, 0);
    glNamedFramebufferRenderbuffer(framebuffer, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                                   depth);
}

Canvas::~Canvas() {
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &color);
    glDeleteRenderbuffers(1, &depth);
}

Pixels Canvas::read() const {
    Pixels pixels(size_t(width) * size_t(height) * 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(color, 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(pixels.size()), pixels.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    return pixels;
}

Triangle::Triangle() : program_(glCreateProgram()) {
    const GLuint stages[] = {
        compile(program_, GL_VERTEX_SHADER,
                "#version 450\nlayout(location = 0) in vec2 p;"
                "void main() { gl_Position = vec4(p, 0, 1); }"),
        compile(program_, GL_FRAGMENT_SHADER,
                "#version 450\nout vec4 color; void main() { color = vec4(1, 0, 1, 1); }")};
    glLinkProgram(program_);
    for (GLuint stage : stages) glDeleteShader(stage);
    const float corners[] = {-1, -1, 0, -1, -1, 0};
    glCreateBuffers(1, &buffer_);
    glNamedBufferStorage(buffer_, sizeof corners, corners, 0);
    glCreateVertexArrays(1, &vertexArray_);
    glVertexArrayVertexBuffer(vertexArray_, 0, buffer_, 0, 2 * sizeof(float));
    glVertexArrayAttribFormat(vertexArray_, 0, 2, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(vertexArray_, 0, 0);
    glEnableVertexArrayAttrib(vertexArray_, 0);
}

Triangle::~Triangle() {
    glDeleteProgram(program_);
    glDeleteVertexArrays(1, &vertexArray_);
    glDeleteBuffers(1, &buffer_);
}

void Triangle::draw(const Canvas& canvas) const {
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.framebuffer);
    glViewport(0, 0, canvas.width, canvas.height);
    glUseProgram(program_);
    glBindVertexArray(vertexArray_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glUseProgram(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace host

#include "tests/support/gl/faulty_gl.h"

#include "tests/support/gl/replaced_gl.h"

#include <GL/glcorearb.h>

#include <string_view>
#include <utility>

namespace rushlight {
namespace {

GLenum pendingError = GL_NO_ERROR;

template <class F>
F real(const char* name) {
    return reinterpret_cast<F>(TestContext::load(name));
}

bool failsNow(GlFault kind) {
    if (FaultyGl::fault != kind) return false;
    const uint32_t number = ++FaultyGl::calls;
    return kind == GlFault::reset ? number >= FaultyGl::call : number == FaultyGl::call;
}

bool outOfMemory() {
    if (!failsNow(GlFault::storage)) return false;
    pendingError = GL_OUT_OF_MEMORY;
    return true;
}

void APIENTRY bufferStorage(GLuint buffer, GLsizeiptr size, const void* data, GLbitfield flags) {
    if (outOfMemory()) return;
    real<PFNGLNAMEDBUFFERSTORAGEPROC>("glNamedBufferStorage")(buffer, size, data, flags);
}
void APIENTRY textureStorage2d(GLuint texture, GLsizei levels, GLenum format, GLsizei width,
                               GLsizei height) {
    if (outOfMemory()) return;
    real<PFNGLTEXTURESTORAGE2DPROC>("glTextureStorage2D")(texture, levels, format, width, height);
}
void APIENTRY textureStorage3d(GLuint texture, GLsizei levels, GLenum format, GLsizei width,
                               GLsizei height, GLsizei depth) {
    if (outOfMemory()) return;
    real<PFNGLTEXTURESTORAGE3DPROC>("glTextureStorage3D")(texture, levels, format, width, height,
                                                          depth);
}
GLenum APIENTRY getError() {
    const GLenum pending = std::exchange(pendingError, GL_NO_ERROR);
    return pending != GL_NO_ERROR ? pending : real<PFNGLGETERRORPROC>("glGetError")();
}
void* APIENTRY mapRange(GLuint buffer, GLintptr offset, GLsizeiptr size, GLbitfield access) {
    if (failsNow(GlFault::mapping)) return nullptr;
    return real<PFNGLMAPNAMEDBUFFERRANGEPROC>("glMapNamedBufferRange")(buffer, offset, size,
                                                                       access);
}
void APIENTRY getShader(GLuint shader, GLenum name, GLint* value) {
    real<PFNGLGETSHADERIVPROC>("glGetShaderiv")(shader, name, value);
    if (name == GL_COMPILE_STATUS && failsNow(GlFault::compilation)) *value = GL_FALSE;
}
void APIENTRY getProgram(GLuint program, GLenum name, GLint* value) {
    real<PFNGLGETPROGRAMIVPROC>("glGetProgramiv")(program, name, value);
    if (name == GL_LINK_STATUS && failsNow(GlFault::linking)) *value = GL_FALSE;
}
GLenum APIENTRY framebufferStatus(GLuint framebuffer, GLenum target) {
    if (failsNow(GlFault::framebuffer)) return GL_FRAMEBUFFER_UNSUPPORTED;
    return real<PFNGLCHECKNAMEDFRAMEBUFFERSTATUSPROC>("glCheckNamedFramebufferStatus")(framebuffer,
                                                                                       target);
}
GLenum APIENTRY resetStatus() {
    if (failsNow(GlFault::reset)) return GL_INNOCENT_CONTEXT_RESET;
    return real<PFNGLGETGRAPHICSRESETSTATUSPROC>("glGetGraphicsResetStatus")();
}
void APIENTRY drawArrays(GLenum mode, GLint first, GLsizei count, GLsizei instances) {
    if (FaultyGl::draws)
        real<PFNGLDRAWARRAYSINSTANCEDPROC>("glDrawArraysInstanced")(mode, first, count, instances);
}
void APIENTRY multiDraw(GLenum mode, GLenum type, const void* indirect, GLsizei count,
                        GLsizei stride) {
    if (FaultyGl::draws)
        real<PFNGLMULTIDRAWELEMENTSINDIRECTPROC>("glMultiDrawElementsIndirect")(
            mode, type, indirect, count, stride);
}

}  // namespace

void FaultyGl::set(GlFault kind, uint32_t number) {
    fault = kind;
    call = number;
    calls = 0;
    pendingError = GL_NO_ERROR;
}

void* FaultyGl::load(const char* name) {
    const ReplacedGl replaced[] = {
        {"glNamedBufferStorage", &bufferStorage},
        {"glTextureStorage2D", &textureStorage2d},
        {"glTextureStorage3D", &textureStorage3d},
        {"glGetError", &getError},
        {"glMapNamedBufferRange", &mapRange},
        {"glGetShaderiv", &getShader},
        {"glGetProgramiv", &getProgram},
        {"glCheckNamedFramebufferStatus", &framebufferStatus},
        {"glGetGraphicsResetStatus", &resetStatus},
        {"glDrawArraysInstanced", &drawArrays},
        {"glMultiDrawElementsIndirect", &multiDraw},
    };
    return loadReplaced(replaced, name);
}

}  // namespace rushlight

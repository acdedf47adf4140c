#include "renderer/backend/gl/gl_storage.h"

#include "renderer/backend/gl/gl_enums.h"

#include <cstdio>

namespace rushlight {
namespace {

// What OpenGL says went wrong. Of errors that the host left, none is taken while all goes well:
// whether storage was made is asked of the object, which is immutable then.
std::string reasonOf(const GlFunctions& gl) {
    constexpr int kMostErrors = 16;  // a lost context may never run out of them
    GLenum last = GL_NO_ERROR;
    for (int i = 0; i < kMostErrors; ++i) {
        const GLenum error = gl.GetError();
        if (error == GL_NO_ERROR) break;
        last = error;
        if (error == GL_OUT_OF_MEMORY) return "it is out of memory";
    }
    char text[32];
    std::snprintf(text, sizeof text, "error 0x%04x", last);
    return last == GL_NO_ERROR ? "it does not say why" : text;
}

std::string megabytes(uint64_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f MiB", double(bytes) / (1 << 20));
    return text;
}

std::string textureText(const TextureDesc& desc) {
    uint64_t bytes = 0;
    for (uint32_t level = 0; level < desc.mipLevels; ++level) bytes += imageBytes(desc, level);
    std::string text = "a texture of " + std::to_string(desc.width) + "x" +
                       std::to_string(desc.height) + " texels";
    if (desc.layers > 1) text += " in " + std::to_string(desc.layers) + " layers";
    return text + " (" + toText(desc.format) + ", " + megabytes(bytes * desc.layers) + ")";
}

tl::unexpected<Error> refused(const GlFunctions& gl, std::string_view label,
                              const std::string& what) {
    return fail(std::string(label), "OpenGL has no room for " + what + ": " + reasonOf(gl) + ".");
}

}  // namespace

Result<void> makeBufferStorage(const GlFunctions& gl, GLuint buffer, std::string_view label,
                               uint64_t bytes, GLbitfield flags) {
    gl.NamedBufferStorage(buffer, GLsizeiptr(bytes), nullptr, flags);
    GLint made = GL_FALSE;
    gl.GetNamedBufferParameteriv(buffer, GL_BUFFER_IMMUTABLE_STORAGE, &made);
    if (!made) return refused(gl, label, "a buffer of " + megabytes(bytes));
    gl.label(GL_BUFFER, buffer, label);
    return {};
}

Result<void> makeTextureStorage(const GlFunctions& gl, GLuint texture, GLenum target,
                                const TextureDesc& desc) {
    const GLsizei levels = GLsizei(desc.mipLevels);
    const GLsizei width = GLsizei(desc.width), height = GLsizei(desc.height);
    const GLenum format = glFormat(desc.format).internal;
    if (target == GL_TEXTURE_2D_ARRAY || target == GL_TEXTURE_CUBE_MAP_ARRAY)
        gl.TextureStorage3D(texture, levels, format, width, height, GLsizei(desc.layers));
    else
        gl.TextureStorage2D(texture, levels, format, width, height);
    GLint made = GL_FALSE;
    gl.GetTextureParameteriv(texture, GL_TEXTURE_IMMUTABLE_FORMAT, &made);
    if (!made) return refused(gl, desc.label, textureText(desc));
    gl.label(GL_TEXTURE, texture, desc.label);
    return {};
}

}  // namespace rushlight

#pragma once
// Memory of buffers and textures, which OpenGL may refuse.

#include "renderer/backend/gl/gl_functions.h"
#include "renderer/rhi/resources.h"

namespace rushlight {

/// Gives a new buffer its storage and its label; an Error names the latter.
Result<void> makeBufferStorage(const GlFunctions& gl, GLuint buffer, std::string_view label,
                               uint64_t bytes, GLbitfield flags);

/// The same for a texture of `target`.
Result<void> makeTextureStorage(const GlFunctions& gl, GLuint texture, GLenum target,
                                const TextureDesc& desc);

}  // namespace rushlight

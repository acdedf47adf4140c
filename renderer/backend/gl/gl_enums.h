#pragma once
// The one translation from the project's enumerations to GL's.

#include "renderer/rhi/resources.h"

#include <GL/glcorearb.h>

namespace rushlight {

struct GlFormat {
    GLenum internal;
    GLenum external;  ///< of transfers, tightly packed
    GLenum type;
};
const GlFormat& glFormat(Format format);

GLenum glTarget(TextureKind kind);
GLenum glWrap(TextureWrap wrap);
GLenum glMagnify(TextureFilter filter);
GLenum glMinify(const SamplerDesc& desc);
GLenum glCompare(CompareOp op);
GLenum glCull(CullMode mode);  ///< not for none

}  // namespace rushlight

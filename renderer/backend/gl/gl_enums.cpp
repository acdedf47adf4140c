#include "renderer/backend/gl/gl_enums.h"

#include <iterator>

namespace rushlight {
namespace {

// clang-format off
// Indexed by Format.
constexpr GlFormat kFormats[] = {
    {GL_NONE,               GL_NONE,            GL_NONE},
    {GL_R8,                 GL_RED,             GL_UNSIGNED_BYTE},
    {GL_RG8,                GL_RG,              GL_UNSIGNED_BYTE},
    {GL_RGBA8,              GL_RGBA,            GL_UNSIGNED_BYTE},
    {GL_SRGB8_ALPHA8,       GL_RGBA,            GL_UNSIGNED_BYTE},
    {GL_RGB10_A2,           GL_RGBA,            GL_UNSIGNED_INT_2_10_10_10_REV},
    {GL_R16F,               GL_RED,             GL_HALF_FLOAT},
    {GL_RG16F,              GL_RG,              GL_HALF_FLOAT},
    {GL_RGBA16F,            GL_RGBA,            GL_HALF_FLOAT},
    {GL_R11F_G11F_B10F,     GL_RGB,             GL_UNSIGNED_INT_10F_11F_11F_REV},
    {GL_R32F,               GL_RED,             GL_FLOAT},
    {GL_RG32F,              GL_RG,              GL_FLOAT},
    {GL_RGBA32F,            GL_RGBA,            GL_FLOAT},
    {GL_R16UI,              GL_RED_INTEGER,     GL_UNSIGNED_SHORT},
    {GL_R32UI,              GL_RED_INTEGER,     GL_UNSIGNED_INT},
    {GL_RGBA32UI,           GL_RGBA_INTEGER,    GL_UNSIGNED_INT},
    {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT},
    {GL_DEPTH_COMPONENT16,  GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT},
};
static_assert(std::size(kFormats) == size_t(Format::depth16) + 1);

// Indexed by their enumerations.
constexpr GLenum kTargets[]  = {GL_TEXTURE_2D, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_CUBE_MAP,
                                GL_TEXTURE_CUBE_MAP_ARRAY};
constexpr GLenum kWraps[]    = {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT};
constexpr GLenum kFilters[]  = {GL_NEAREST, GL_LINEAR};
constexpr GLenum kCompares[] = {GL_ALWAYS, GL_GEQUAL, GL_GREATER, GL_EQUAL, GL_LESS};
// By texture filter, then mip filter.
constexpr GLenum kMipFilters[2][2] = {{GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR},
                                      {GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_LINEAR}};
// clang-format on

}  // namespace

const GlFormat& glFormat(Format format) { return kFormats[size_t(format)]; }

GLenum glTarget(TextureKind kind) { return kTargets[size_t(kind)]; }
GLenum glWrap(TextureWrap wrap) { return kWraps[size_t(wrap)]; }
GLenum glMagnify(TextureFilter filter) { return kFilters[size_t(filter)]; }
GLenum glMinify(const SamplerDesc& desc) {
    return desc.useMipmaps ? kMipFilters[size_t(desc.minify)][size_t(desc.mipmap)]
                           : kFilters[size_t(desc.minify)];
}
GLenum glCompare(CompareOp op) { return kCompares[size_t(op)]; }
GLenum glCull(CullMode mode) { return mode == CullMode::back ? GL_BACK : GL_FRONT; }

}  // namespace rushlight

#pragma once
// API-neutral descriptions of GPU objects and the handles that creating them returns. Zero means
// default.

#include "engine/core/handle.h"
#include "engine/core/math.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace rushlight {

using BufferHandle = Handle<struct BufferTag>;
using TextureHandle = Handle<struct TextureTag>;
using SamplerHandle = Handle<struct SamplerTag>;
using PipelineHandle = Handle<struct PipelineTag>;

enum class Format : uint8_t {
    none,
    r8,
    rg8,
    rgba8,
    rgba8Srgb,
    rgb10a2,
    r16f,
    rg16f,
    rgba16f,
    r11g11b10f,
    r32f,
    rg32f,
    rgba32f,
    r16ui,
    r32ui,
    rgba32ui,
    depth32f,
    depth16,
};

/// Bytes of one texel.
uint32_t bytesPerTexel(Format format);
const char* toText(Format format);
bool isDepth(Format format);
bool isInteger(Format format);
/// Whether a BindTexelBuffer may have it.
bool isTexelBufferFormat(Format format);

/// Width or height of a mip level.
constexpr uint32_t mipSize(uint32_t size, uint32_t level) {
    const uint32_t shifted = level < 32 ? size >> level : 0;
    return shifted ? shifted : 1;
}

enum class TextureKind : uint8_t { texture2d, texture2dArray, cube, cubeArray };

struct TextureDesc {
    std::string_view label;  ///< shown in debuggers and messages; copied
    TextureKind kind = TextureKind::texture2d;
    Format format = Format::rgba8;
    uint32_t width = 1;
    uint32_t height = 1;
    uint32_t layers = 1;  ///< array layers; 6 for a cube, 6 for each of a cube array
    uint32_t mipLevels = 1;
};

/// Bytes of one layer of one mip level.
uint64_t imageBytes(const TextureDesc& desc, uint32_t mipLevel);

/// A box of texels of one mip level. Rows of `data` are tightly packed, first row = lowest v
/// (glTF's top row).
struct TextureRegion {
    uint32_t mipLevel = 0;
    uint32_t layer = 0;
    uint32_t layerCount = 1;
    uint32_t width = 0;
    uint32_t height = 0;
};

enum class BufferUsage : uint8_t { vertex, index, texel };

struct BufferDesc {
    std::string_view label;
    uint64_t size = 0;  ///< bytes
    BufferUsage usage = BufferUsage::vertex;
};

enum class TextureWrap : uint8_t { repeat, clampToEdge, mirroredRepeat };
enum class TextureFilter : uint8_t { nearest, linear };

struct SamplerDesc {
    TextureWrap wrapU = TextureWrap::repeat;
    TextureWrap wrapV = TextureWrap::repeat;
    TextureFilter magnify = TextureFilter::linear;
    TextureFilter minify = TextureFilter::linear;
    TextureFilter mipmap = TextureFilter::linear;
    bool useMipmaps = true;
    bool compareGreaterEqual = false;  ///< a shadow sampler: reversed-Z comparison `reference >=
                                       ///< texel`
    float maxAnisotropy = 1;
    bool operator==(const SamplerDesc&) const = default;
};

enum class CullMode : uint8_t { none, back, front };
enum class CompareOp : uint8_t { always, greaterOrEqual, greater, equal, less };
enum class BlendMode : uint8_t {
    off,
    premultiplied,  ///< one, one minus source alpha
    additive,       ///< one, one
    filtered,       ///< one, the shader's second output of target 0: what is behind, seen through a
                    ///< colour
    absorbing,      ///< colour: the product of both; alpha: the greater one
};

/// How a pipeline reads vertices. Locations and binding slots: shaders/interop/bindings.h.
enum class VertexLayout : uint8_t {
    none,      ///< the vertex shader makes its own (full-screen triangle)
    position,  ///< VertexPosition, instances: depth only
    standard,  ///< VertexPosition + VertexSurface, instances
    extended,  ///< VertexPosition + VertexSurface + VertexExtra, instances
    overlay,   ///< OverlayVertex
};

/// A program with its fixed-function state. Shader paths are names in the shader library
/// ("passes/gbuffer.vert").
struct PipelineDesc {
    std::string_view label = {};
    std::string_view vertexShader = {};
    std::string_view fragmentShader = {};
    std::span<const std::string_view> defines = {};  ///< "NAME" or "NAME VALUE"; order matters to
                                                     ///< the cache
    // GLSL to be compiled as it is, with nothing looked up or put before it; the names above are
    // for messages. Both or none.
    std::string_view vertexSource = {};
    std::string_view fragmentSource = {};
    VertexLayout layout = VertexLayout::none;
    bool movingInstances = false;  ///< the instance stream also holds previous transforms
    CullMode cull = CullMode::none;
    bool depthClamp = false;
    float depthBias = 0;       ///< constant, in units of the depth buffer's resolution
    float depthBiasSlope = 0;  ///< times the maximal depth slope
    CompareOp depthTest = CompareOp::always;
    bool depthWrite = false;
    BlendMode blend = BlendMode::off;
    bool lines = false;  ///< line list instead of triangle list
};

// Vertex streams, as the GPU reads them.

struct VertexPosition {
    vec3 position;
};
static_assert(sizeof(VertexPosition) == 12);

/// Tangent frame and first UV set.
///
///     frame.xy  octahedral normal, snorm16
///     frame.z   octahedral tangent x, snorm16
///     frame.w   octahedral tangent y, remapped to (0, 1], negated when the bitangent is mirrored,
///     snorm16
struct VertexSurface {
    std::array<int16_t, 4> frame;
    vec2 uv0;
};
static_assert(sizeof(VertexSurface) == 16);

struct VertexExtra {
    vec2 uv1;
    std::array<uint16_t, 4> color;  ///< unorm16, linear
};
static_assert(sizeof(VertexExtra) == 16);

/// One visible instance: three rows of the affine world-from-local matrix, and what the shader
/// looks up.
struct InstanceData {
    vec4 row0, row1, row2;
    uint32_t material;  ///< index of MaterialData
    uint32_t id;        ///< the caller's Instance::id
    uint32_t reserved0;
    uint32_t reserved1;
};
static_assert(sizeof(InstanceData) == 64);

/// InstanceData of something that moves: where it was one frame ago.
struct MovingInstanceData {
    InstanceData now;
    vec4 previousRow0, previousRow1, previousRow2;
};
static_assert(sizeof(MovingInstanceData) == 112);

/// A user-interface vertex: pixels from the top left of the target, sRGB colour with straight
/// alpha.
struct OverlayVertex {
    vec2 position;
    vec2 uv;
    uint32_t color;  ///< 0xAABBGGRR
};
static_assert(sizeof(OverlayVertex) == 20);

/// As glMultiDrawElementsIndirect reads it.
struct DrawIndexedCommand {
    uint32_t indexCount;
    uint32_t instanceCount;
    uint32_t firstIndex;
    int32_t baseVertex;
    uint32_t baseInstance;
};
static_assert(sizeof(DrawIndexedCommand) == 20);

/// The host's framebuffer, for passes with BeginPass::toFrameTarget.
struct FrameTarget {
    uint32_t framebuffer = 0;  ///< a GL framebuffer name; 0 is the window
    uint32_t width = 0;
    uint32_t height = 0;
    bool topRowFirst = false;  ///< the host reads rows from the top; GL has them from the bottom
};

}  // namespace rushlight

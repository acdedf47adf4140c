#pragma once
// What the host creates before it draws: meshes, images, materials, environments. Spans are copied
// during the call.

#include "engine/core/math.h"
#include "renderer/rhi/resources.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace rushlight {

using MeshHandle = Handle<struct MeshTag>;
using ImageHandle = Handle<struct ImageTag>;
using MaterialHandle = Handle<struct MaterialTag>;
using EnvironmentHandle = Handle<struct EnvironmentTag>;
using IrradianceVolumeHandle = Handle<struct IrradianceVolumeTag>;

/// Triangles. Every attribute span is empty or as long as `positions`; copied.
struct MeshDesc {
    std::string_view label;
    std::span<const vec3> positions;  ///< metres, local space; finite
    std::span<const vec3> normals;    ///< unit; empty: face normals are made
    std::span<const vec4> tangents;  ///< unit xyz, w = ±1 the sign of the bitangent; empty: normal
                                     ///< maps are ignored
    std::span<const vec2> uv0;       ///< v = 0 is the top row of an image
    std::span<const vec2> uv1;
    std::span<const vec4> colors;       ///< linear, multiply the base colour
    std::span<const uint32_t> indices;  ///< three a triangle, counter-clockwise is the front
    bool lods = true;  ///< make coarser levels, drawn where the difference is too small to see
                       ///< (renderer/geometry/mesh_lods.h)
};

/// 8-bit RGBA, rows from the top, tightly packed; copied. Mip levels are made.
struct ImageDesc {
    std::string_view label;
    uint32_t width = 0;  ///< 1 to 16,384
    uint32_t height = 0;
    bool srgb = false;  ///< colour data (base colour, emissive); false for normals and parameters
    std::span<const uint8_t> pixels;
};

/// A use of an image. The transform maps a uv as KHR_texture_transform: scale, rotate, offset.
struct TextureSlot {
    ImageHandle image;
    SamplerDesc sampler;
    uint8_t uvSet = 0;
    vec2 offset{0};
    float rotation = 0;
    vec2 scale{1};
};

enum class AlphaMode : uint8_t { opaque, mask, blend };

/// Metallic-roughness, as glTF 2.0 section 3.9.
struct MaterialDesc {
    std::string_view label;
    vec4 baseColor{1};
    TextureSlot baseColorTexture;  ///< srgb
    float metallic = 1;
    float roughness = 1;
    TextureSlot metallicRoughnessTexture;  ///< G roughness, B metallic
    float normalScale = 1;
    TextureSlot normalTexture;
    float occlusionStrength = 1;
    TextureSlot occlusionTexture;             ///< R
    vec3 emissive{0};                         ///< radiance in the units of the lights, unbounded
    TextureSlot emissiveTexture;              ///< srgb
    AlphaMode alphaMode = AlphaMode::opaque;  ///< coverage; what is covered may still let light
                                              ///< through
    float alphaCutoff = 0.5f;
    /// KHR_materials_transmission: the share, 0 to 1, of the light that is not mirrored that goes
    /// through, coloured by the base colour, as through a pane without thickness: not refracted,
    /// not blurred. Above 0 the surface is drawn with the blended ones, and colours the light
    /// behind it instead of hiding it. Nothing where `unlit`.
    float transmission = 0;
    TextureSlot transmissionTexture;  ///< R
    vec3 transmissionColor{1};  ///< 0 to 1, times the base colour: what a body behind the surface
                                ///< absorbs
    bool doubleSided = false;
    bool unlit = false;
};

/// Equirectangular radiance: u = atan2(z, x)/2π + ½, v from the top = ½ − asin(y)/π. Copied and
/// prefiltered.
struct EnvironmentDesc {
    std::string_view label;
    uint32_t width = 0;
    uint32_t height = 0;
    std::span<const vec3> pixels;
};

/// A cube map (OpenGL's faces and orientation) that is blurred already. Copied. An environment's
/// levels are of evenly spaced roughness from 0 to 1: of six, level i is that of i / 5; these may
/// be of another number, evenly spaced too. A single one is taken to be sharp and is prefiltered.
struct PrefilteredEnvironmentDesc {
    std::string_view label;
    uint32_t size = 0;             ///< texels along a face of level 0; a power of two up to 4,096
    uint32_t levels = 0;           ///< each of half the size of the one before
    std::span<const vec3> texels;  ///< radiance; level by level, in it face by face, rows from t =
                                   ///< 0
    /// Spherical harmonics of irradiance, real, without signs of their own: 1; y, z, x; xy, yz,
    /// 3z²-1, xz, x²-y² (Ramamoorthi and Hanrahan 2001).
    std::array<vec3, 9> irradiance{};
    quat rotation{1, 0, 0, 0};  ///< from its space to the world's
};

}  // namespace rushlight

#pragma once
// One frame as data: what the host hands over. Spans are read during Renderer::render alone.
// Units: metres, seconds, radians; right-handed, y up. Colours are linear Rec.709 unless said otherwise.

#include "engine/core/bounds.h"
#include "engine/core/math.h"
#include "renderer/commands/resources.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace rushlight {

using MeshHandle = Handle<struct MeshTag>;
using ImageHandle = Handle<struct ImageTag>;
using MaterialHandle = Handle<struct MaterialTag>;
using EnvironmentHandle = Handle<struct EnvironmentTag>;
using WorldHandle = Handle<struct WorldTag>;
using InstanceHandle = Handle<struct InstanceTag>;  ///< within its world

// ---- resources ---------------------------------------------------------------------------------------------------

/// Triangles. Every attribute span is empty or as long as `positions`; copied.
struct MeshDesc {
    std::string_view label;
    std::span<const vec3> positions;  ///< metres, local space; finite
    std::span<const vec3> normals;    ///< unit; empty: face normals are made
    std::span<const vec4> tangents;   ///< unit xyz, w = ±1 the sign of the bitangent; empty: normal maps are ignored
    std::span<const vec2> uv0;        ///< v = 0 is the top row of an image
    std::span<const vec2> uv1;
    std::span<const vec4> colors;  ///< linear, multiply the base colour
    std::span<const uint32_t> indices;  ///< three a triangle, counter-clockwise is the front
    bool lods = true;  ///< make coarser levels, drawn where the difference is too small to see (renderer/frame/mesh_lods.h)
};

/// 8-bit RGBA, rows from the top, tightly packed; copied. Mip levels are made.
struct ImageDesc {
    std::string_view label;
    uint32_t width = 0;   ///< 1 to 16,384
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
    TextureSlot occlusionTexture;  ///< R
    vec3 emissive{0};              ///< radiance in the units of the lights, unbounded
    TextureSlot emissiveTexture;   ///< srgb
    AlphaMode alphaMode = AlphaMode::opaque;
    float alphaCutoff = 0.5f;
    bool doubleSided = false;
    bool unlit = false;
};

/// Equirectangular radiance: u = atan2(z, x)/2π + ½, v from the top = ½ − asin(y)/π. Copied and prefiltered.
struct EnvironmentDesc {
    std::string_view label;
    uint32_t width = 0;
    uint32_t height = 0;
    std::span<const vec3> pixels;
};

// ---- the frame ---------------------------------------------------------------------------------------------------

enum InstanceFlags : uint32_t {
    kInstanceCastsShadow = 1,
    kInstanceMoving = 2,  ///< `previousTransform` indexes FrameInput::previousTransforms
    kInstanceOccluder = 4,    ///< hides much: considered before the occluders that the renderer finds itself
    kInstanceNoOccluder = 8,  ///< never considered as one
};

struct Instance {
    mat4x3 worldFromLocal{1.0f};
    MeshHandle mesh;
    MaterialHandle material;  ///< zero: glTF's default material
    uint32_t id = 0;          ///< the caller's; kept in the order of ties
    uint32_t flags = kInstanceCastsShadow;
    uint32_t previousTransform = 0;
};

/// A camera looks along -z of its own space.
struct View {
    mat4 viewFromWorld{1};
    bool perspective = true;
    float verticalFov = 0.785f;     ///< perspective
    float orthoHalfHeight = 1;      ///< orthographic
    float aspect = 0;               ///< width over height; 0: that of the target
    float nearPlane = 0.1f;         ///< > 0 for perspective
    float farPlane = 0;             ///< 0: infinite (perspective only)
    mat4 previousViewFromWorld{0};  ///< of the last frame, for velocity; all zero: the camera stands still
};

struct DirectionalLight {
    vec3 direction{0, -1, 0};  ///< unit, world space, the way the light travels
    vec3 illuminance{1};       ///< lux times colour
    bool castsShadow = true;
};

/// Point and spot lights. Attenuation as KHR_lights_punctual: max(min(1-(d/range)^4, 1), 0) / d².
struct PunctualLight {
    vec3 position{0};
    vec3 intensity{1};          ///< candela times colour
    float range = 0;            ///< metres; 0: unbounded
    vec3 direction{0, -1, 0};   ///< unit, world space, the way a spot shines
    float innerConeAngle = 0;   ///< radians from the axis
    float outerConeAngle = -1;  ///< < 0: a point light
};

enum class Background : uint8_t { color, environment, transparent };

struct Lighting {
    std::span<const DirectionalLight> directional;  ///< at most kMaxDirectionalLights; the first that casts has shadows
    std::span<const PunctualLight> punctual;        ///< at most kMaxPunctualLights
    EnvironmentHandle environment;                  ///< zero: the hemisphere ambient below
    float environmentRotation = 0;                  ///< radians about +y
    float environmentIntensity = 1;
    vec3 ambientSky{0};     ///< irradiance/π from above, used when there is no environment
    vec3 ambientGround{0};  ///< from below
    Background background = Background::color;
    vec3 backgroundColor{0};  ///< linear radiance; not tone mapped to anything else than the surfaces are
};

inline constexpr uint32_t kMaxDirectionalLights = 4;
inline constexpr uint32_t kMaxPunctualLights = 4096;

enum class ToneMap : uint8_t { none, neutral, agx, aces };
enum class AntiAliasing : uint8_t { off, fxaa };

/// What the last pass shows instead of the frame, for looking into it. In the deck's order.
enum class ShownImage : uint8_t {
    frame,
    bounds,  ///< the frame with the visible objects' boxes drawn over it
    baseColor,
    metallic,
    roughness,
    normal,
    emissive,
    occlusion,
    velocity,
    depth,
    shadow,    ///< the cascades side by side
    clusters,  ///< lights per froxel as a heat map
    lighting,  ///< HDR after deferred lighting, before forward
    forward,   ///< HDR after forward
    bloom,
    tonemap,  ///< before anti-aliasing
    count
};
const char* toText(ShownImage image);  ///< the names of `--pass`

struct FrameSettings {
    bool shadows = true;
    uint32_t shadowCascades = 4;  ///< 1 to 4
    uint32_t shadowResolution = 2048;
    float shadowDistance = 0;  ///< metres; 0: chosen from the scene and the far plane
    bool shadowCaching = true;  ///< a cascade whose view and casters are those of the last frame is not drawn again
    bool bloom = true;
    float bloomStrength = 0.04f;
    float exposureScale = 1;     ///< linear factor on radiance, used when neither below is
    bool useExposureValue = false;
    float exposureValue = 0;     ///< EV100
    bool autoExposure = false;
    float deltaTime = 1.0f / 60;  ///< seconds since the last frame, for what adapts
    ToneMap toneMap = ToneMap::neutral;
    AntiAliasing antiAliasing = AntiAliasing::fxaa;
    bool dither = true;
    ShownImage show = ShownImage::frame;
    bool frustumCulling = true;
    bool occlusionCulling = true;  ///< leave out what opaque objects hide, as far as the CPU can tell
    /// Simplified meshes are shown where their surface is off by at most this many pixels; 0: never.
    float lodPixelError = 0.3f;
    float shadowLodTexelError = 0.3f;  ///< as lodPixelError, in texels of the shadow map
    float smallObjectPixels = 1;    ///< objects that are smaller across, in pixels or shadow texels, are left out; 0: none
};

/// A run of overlay triangles with one scissor rectangle (pixels from the top left).
struct OverlayBatch {
    uint32_t firstIndex = 0;
    uint32_t indexCount = 0;
    ivec2 clipLow{0};
    ivec2 clipHigh{0};
};

/// A user interface drawn over the frame, in sRGB, after everything. `image` (coverage in alpha) is sampled at uv.
struct Overlay {
    std::span<const OverlayVertex> vertices;
    std::span<const uint32_t> indices;
    std::span<const OverlayBatch> batches;
    ImageHandle image;
};

struct FrameInput {
    View view;
    WorldHandle world;                    ///< instances that the renderer keeps; zero: none
    std::span<const Instance> instances;  ///< others, for this frame; equal to the last frame's they cost a comparison
    std::span<const mat4x3> previousTransforms;
    Lighting lighting;
    FrameSettings settings;
    Overlay overlay;
};

}  // namespace rushlight

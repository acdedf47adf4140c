#pragma once
// What a pixel is made of: the surface, each light's share of it, what comes over it, and the way
// to the display. The shares are measured: the frame is rendered again with one light alone, with
// no light but the ambient one, without fog and so on, and its linear pictures are read back, once
// for all pixels that are asked about.

#include "renderer/renderer.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace rushlight {

enum class LightKind : uint8_t { sun, punctual, area };

/// Linear radiance that one light gives the pixel's surface.
struct LightShare {
    LightKind kind = LightKind::sun;
    uint32_t index = 0;  ///< in Lighting::directional, punctual or area
    vec3 radiance{0};
    float shadow = 1;  ///< share of its light that nothing hides; 1 where it casts no shadow
};

/// The opaque surface of a pixel as the G-buffer has it, to 8 bits.
struct PixelSurface {
    std::optional<InstanceFacts> object;
    float viewDepth = 0;  ///< metres before the camera
    vec3 position{0};     ///< world space
    vec3 baseColor{0};    ///< linear
    float metallic = 0;
    float roughness = 0;
    vec3 normal{0};       ///< world space
    float occlusion = 1;  ///< what the material says
};

/// All radiances are linear, before exposure. Where there is no surface the background is
/// `background` alone.
struct PixelExplanation {
    uvec2 pixel{0};                  ///< from the top left
    std::array<uint8_t, 4> shown{};  ///< what the frame shows there: sRGB, straight alpha
    std::optional<PixelSurface> surface;
    std::optional<InstanceFacts> blended;  ///< the nearest blended surface before it

    vec3 background{0};
    std::vector<LightShare> lights;  ///< that reach it; the brightest first
    vec3 ambientDiffuse{0};
    vec3 ambientSpecular{0};
    float ambientVisibility = 1;  ///< what ambient occlusion of the screen leaves of the ambient
                                  ///< light
    vec3 emissive{0};             ///< and what unlit surfaces show
    vec3 reflections{0};  ///< what the screen's reflections add to the ambient specular light, or
                          ///< take
    vec3 fog{0};          ///< what fog adds, less what it takes
    vec3 blendedSurfaces{0};  ///< as fog
    vec3 bloom{0};            ///< as fog
    float alpha = 1;          ///< of the linear picture

    float exposure = 1;  ///< the factor on radiance
    ToneMap toneMap = ToneMap::none;
    vec3 antiAliasing{0};  ///< what it changes of the displayed value, [-1, 1]

    // What addUp() makes of the above:
    vec3 radiance{0};  ///< the sum of all shares
    vec3 display{0};   ///< tone mapped, linear, [0, 1]
    vec3 encoded{0};   ///< sRGB
    vec3 dither{0};    ///< added before rounding
    vec3 sum{0};       ///< encoded + dither + antiAliasing
    float error = 0;   ///< the largest difference of `sum` and `shown`, [0, 1]
};

/// The sum of the shares and what exposure, tone map and dithering make of it, by the lines that
/// the shaders are compiled from. `size` is the picture's.
void addUp(PixelExplanation& pixel, const FrameInput& input, uvec2 size);

/// Explains pixels of the frame that `input` describes. Frames are rendered until all is known:
/// about 20, and two for each light that reaches one of the pixels. An Error for a pixel outside of
/// the picture, and as Renderer::render. FrameSettings::debugView is not looked at, nor the
/// overlay.
Result<std::vector<PixelExplanation>> explain(Renderer& renderer, const FrameInput& input,
                                              uvec2 size, std::span<const uvec2> pixels);

}  // namespace rushlight

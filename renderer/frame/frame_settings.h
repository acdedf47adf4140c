#pragma once
// How a frame is drawn, and what of it is shown.

#include "renderer/frame/debug_view.h"

#include <cstdint>

namespace rushlight {

enum class ToneMap : uint8_t { none, neutral, agx, aces };
enum class AntiAliasing : uint8_t { off, fxaa };
enum class ShadowFilter : uint8_t {
    hard,  ///< one bilinear comparison
    pcf,   ///< a tent of 3x3 of them
    soft,  ///< penumbrae that grow with the distance from what casts them, by the size of the light
};

/// How finely the surroundings of a pixel are searched for what hides the ambient light: 8, 12 or
/// 48 places.
enum class AmbientOcclusion : uint8_t { off, low, medium, high };

/// Whose shadows have detail from the screen.
enum class ContactShadows : uint8_t {
    off,
    sun,    ///< the first sun that casts shadows
    lights  ///< and each point and spot light that has a shadow
};

struct FrameSettings {
    bool shadows = true;
    uint32_t shadowCascades = 4;  ///< 1 to 4
    uint32_t shadowResolution = 2048;
    float shadowDistance = 0;   ///< metres; 0: chosen from the scene and the far plane
    bool shadowCaching = true;  ///< a cascade whose view and casters are those of the last frame is
                                ///< not drawn again
    bool lightShadows = false;  ///< of point, spot and area lights (castsShadow)
    uint32_t shadowAtlasSize = 4096;  ///< texels a side of the map that those lights share; 256 to
                                      ///< 16,384, rounded down to 2^n
    uint32_t shadowTileSize = 1024;   ///< the most texels a side of a light's face; 64 to
                                      ///< shadowAtlasSize, rounded down to 2^n
    ShadowFilter shadowFilter = ShadowFilter::pcf;
    /// Detail that is too fine for the shadow maps shadows what is next to it, as far as the screen
    /// shows it. On opaque surfaces: blended ones stand on nothing that the depth buffer knows.
    ContactShadows contactShadows = ContactShadows::off;
    float contactShadowLength = 0.3f;  ///< metres, over 0: fading out over the last third
    /// Surfaces hide ambient light from each other, as far as the screen shows it. Of opaque
    /// surfaces; costs nothing where a frame has no ambient light.
    AmbientOcclusion ambientOcclusion = AmbientOcclusion::off;
    float ambientOcclusionRadius = 1;  ///< metres, over 0: what is further away hides nothing
    /// Smooth surfaces mirror what the screen shows, instead of the environment where that is
    /// known. Of opaque surfaces, before blended ones are drawn.
    bool reflections = false;
    /// Surfaces mirror what is around them: the environment, the hemisphere, probes. Without it
    /// neither does the screen; what ambient light is left is the diffuse one.
    bool ambientReflections = true;
    bool bloom = true;
    float bloomStrength = 0.04f;
    float exposureScale = 1;  ///< linear factor on radiance, used when neither below is
    bool useExposureValue = false;
    float exposureValue = 0;  ///< EV100
    bool autoExposure = false;
    float deltaTime = 1.0f / 60;  ///< seconds since the last frame, for what adapts
    /// The picture is the same whatever frames were before, but for what moves: the exposure is
    /// this frame's, levels of detail and the sizes of shadow maps are chosen anew. Else they
    /// follow slowly and reluctantly.
    bool cut = false;
    ToneMap toneMap = ToneMap::neutral;
    AntiAliasing antiAliasing = AntiAliasing::fxaa;
    bool dither = true;
    DebugView debugView = DebugView::none;  ///< in place of the frame
    bool frustumCulling = true;
    bool occlusionCulling = true;  ///< leave out what opaque objects hide, as far as the CPU can
                                   ///< tell
    /// Simplified meshes are shown where their surface is off by at most this many pixels; 0:
    /// never.
    float lodPixelError = 0.18f;
    float shadowLodTexelError = 0.3f;  ///< as lodPixelError, in texels of the shadow map
    float smallObjectPixels = 1;  ///< objects that are smaller across, in pixels or shadow texels,
                                  ///< are left out; 0: none
};

}  // namespace rushlight

#pragma once
// What makes a light shine unevenly: measured distributions (photometric webs, IES profiles) and
// cookies, pictures that it throws.

#include "renderer/frame/resource_descs.h"

namespace rushlight {

using LightProfileHandle = Handle<struct LightProfileTag>;
using LightCookieHandle = Handle<struct LightCookieTag>;

/// A photometric web of type C (IESNA LM-63), around the light's direction. Only its shape counts:
/// where it is largest it is 1, times PunctualLight::intensity. For a light as measured, give that
/// candela as the intensity.
struct LightProfileDesc {
    std::string_view label;
    /// Degrees from the light's direction, 0 to 180, increasing, two at least. Beyond the last and
    /// before the first it is dark; between, linear.
    std::span<const float> verticalAngles;
    /// Degrees about the direction, counter-clockwise seen from behind the light, starting from its
    /// right; increasing. 0 alone: the same all around; 0 to 90: mirrored about both planes; 0 to
    /// 180, or 90 to 270: about one; 0 to 360.
    std::span<const float> horizontalAngles;
    std::span<const float> candela;  ///< of each horizontal angle in turn, at all vertical ones;
                                     ///< not negative
};

/// A picture that tints the light. A spot throws it along its cone: it touches the circle of the
/// outer cone, upright and not mirrored for who looks along with the light. Around a point light
/// (or a spot of over 80 degrees from its axis) it is equirectangular, the middle in the light's
/// direction. Resampled to 256x256; alpha is not read.
struct LightCookieDesc {
    std::string_view label;
    ImageDesc image;
};

inline constexpr uint32_t kMaxLightPatterns = 128;  ///< profiles and cookies together
inline constexpr float kWidestCookieCone = 1.396f;  ///< radians from the axis

}  // namespace rushlight

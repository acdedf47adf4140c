#pragma once
// What makes a light shine unevenly: measured distributions (photometric webs, IES profiles) and cookies, pictures that
// it throws.

#include "engine/core/result.h"
#include "renderer/frame/resource_descs.h"

#include <map>
#include <vector>

namespace rushlight {

using LightProfileHandle = Handle<struct LightProfileTag>;
using LightCookieHandle = Handle<struct LightCookieTag>;

/// A photometric web of type C (IESNA LM-63), around the light's direction. Only its shape counts: where it is largest it
/// is 1, times PunctualLight::intensity. For a light as measured, give that candela as the intensity.
struct LightProfileDesc {
    std::string_view label;
    /// Degrees from the light's direction, 0 to 180, increasing, two at least. Beyond the last and before the first it is
    /// dark; between, linear.
    std::span<const float> verticalAngles;
    /// Degrees about the direction, counter-clockwise seen from behind the light, starting from its right; increasing.
    /// 0 alone: the same all around; 0 to 90: mirrored about both planes; 0 to 180, or 90 to 270: about one; 0 to 360.
    std::span<const float> horizontalAngles;
    std::span<const float> candela;  ///< of each horizontal angle in turn, at all vertical ones; not negative
};

/// A picture that tints the light. A spot throws it along its cone: it touches the circle of the outer cone, upright and not
/// mirrored for who looks along with the light. Around a point light (or a spot of over 80 degrees from its axis) it is
/// equirectangular, the middle in the light's direction. Resampled to 256x256; alpha is not read.
struct LightCookieDesc {
    std::string_view label;
    ImageDesc image;
};

inline constexpr uint32_t kMaxLightPatterns = 128;  ///< profiles and cookies together
inline constexpr float kWidestCookieCone = 1.396f;  ///< radians from the axis

/// Either of them, as shaders and paths look it up.
struct LightPattern {
    float perRadian = 0;       ///< of a profile's vertical angle; 0: a cookie
    std::vector<vec3> texels;  ///< RL_LIGHT_PATTERN_SIDE squared, linear, rows from the top

    static Result<LightPattern> make(const LightProfileDesc&);
    static Result<LightPattern> make(const LightCookieDesc&);

    /// The factor on the light in a direction of its frame (interop/light_patterns.h). `cotangent` is not read by profiles.
    vec3 factor(const vec3& direction, float cotangent) const;
};

struct PunctualLight;

/// For those who look them up without a renderer, by the handles that a renderer gave.
class LightPatternSet {
public:
    void set(LightProfileHandle profile, LightPattern pattern) { profiles_[profile.value] = std::move(pattern); }
    void set(LightCookieHandle cookie, LightPattern pattern) { cookies_[cookie.value] = std::move(pattern); }
    /// Null when there is none.
    const LightPattern* find(LightProfileHandle profile) const { return find(profiles_, profile.value); }
    const LightPattern* find(LightCookieHandle cookie) const { return find(cookies_, cookie.value); }
    /// The factor on the light that goes from it in a unit direction of the world.
    vec3 factor(const PunctualLight& light, const vec3& direction) const;

private:
    using Patterns = std::map<uint32_t, LightPattern>;
    static const LightPattern* find(const Patterns& patterns, uint32_t handle) {
        const auto found = patterns.find(handle);
        return found == patterns.end() ? nullptr : &found->second;
    }
    Patterns profiles_, cookies_;
};


/// A light's frame and how it spans its cookie.
struct LightPatternFrame {
    vec3 right, up, forward;  ///< unit, at right angles
    float cotangent = 0;      ///< see cookieCoordinates()
};
LightPatternFrame patternFrameOf(const PunctualLight& light);

}  // namespace rushlight

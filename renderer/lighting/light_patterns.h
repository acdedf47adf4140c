#pragma once
// Light profiles and cookies as tables that shaders, paths and bakes look up alike.

#include "engine/core/result.h"
#include "renderer/frame/lights.h"

#include <map>
#include <vector>

namespace rushlight {

/// Either of them, as shaders and paths look it up.
struct LightPattern {
    float perRadian = 0;       ///< of a profile's vertical angle; 0: a cookie
    std::vector<vec3> texels;  ///< RL_LIGHT_PATTERN_SIDE squared, linear, rows from the top

    static Result<LightPattern> make(const LightProfileDesc&);
    static Result<LightPattern> make(const LightCookieDesc&);

    /// The factor on the light in a direction of its frame (interop/light_patterns.h). `cotangent`
    /// is not read by profiles.
    vec3 factor(const vec3& direction, float cotangent) const;
};

/// For those who look them up without a renderer, by the handles that a renderer gave.
class LightPatternSet {
public:
    void set(LightProfileHandle profile, LightPattern pattern) {
        profiles_[profile.value] = std::move(pattern);
    }
    void set(LightCookieHandle cookie, LightPattern pattern) {
        cookies_[cookie.value] = std::move(pattern);
    }
    /// Null when there is none.
    const LightPattern* find(LightProfileHandle profile) const {
        return find(profiles_, profile.value);
    }
    const LightPattern* find(LightCookieHandle cookie) const {
        return find(cookies_, cookie.value);
    }
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

#pragma once
// The light that is baked, prepared for paths that look for it.

#include "engine/core/jobs.h"
#include "engine/core/result.h"
#include "renderer/raytrace/bake_lighting.h"
#include "renderer/raytrace/ray_random.h"

#include <vector>

namespace rushlight {

/// A direction to the sky, drawn by how bright it is.
struct SkySample {
    vec3 direction{0, 1, 0};
    vec3 radiance{0};
    float density = 0;  ///< per steradian; 0: there is no such direction
};

class BakeLight {
public:
    /// An Error when a light is not finite. The environment is kept at most 128 texels wide.
    static Result<BakeLight> create(const BakeLighting& lighting, JobSystem& jobs);

    std::span<const DirectionalLight> suns() const { return suns_; }
    std::span<const PunctualLight> punctual() const { return punctual_; }
    std::span<const AreaLight> area() const { return area_; }
    /// The factor of a light's profile and cookie.
    vec3 pattern(const PunctualLight& light, const vec3& direction) const {
        return patterns_ && (light.profile || light.cookie) ? patterns_->factor(light, direction)
                                                            : vec3(1);
    }
    /// Of a unit direction to where nothing is.
    vec3 sky(const vec3& direction) const;
    SkySample sampleSky(RayRandom& random) const;
    /// With which sampleSky() draws a direction.
    float skyDensity(const vec3& direction) const;

private:
    void makeTable(const BakeLighting& lighting, JobSystem& jobs);
    vec3 toTable(const vec3& d) const {
        return {turn_.x * d.x - turn_.y * d.z, d.y, turn_.y * d.x + turn_.x * d.z};
    }
    uint32_t texelOf(const vec3& tableDirection) const;

    std::vector<DirectionalLight> suns_;  // directions of unit length
    std::vector<PunctualLight> punctual_;
    std::vector<AreaLight> area_;
    const LightPatternSet* patterns_ = nullptr;
    uint32_t width_ = 0, height_ = 0;  // of the table, equirectangular
    std::vector<vec3> radiance_;
    std::vector<float> density_;     // by texel, per steradian
    std::vector<float> cumulative_;  // by texel, up to 1
    vec2 turn_{1, 0};
};

}  // namespace rushlight

#pragma once
// Light in the air of an Earth-like planet: Rayleigh scattering by molecules, Mie scattering by
// haze, absorption by ozone, and many scatterings as one. Coefficients: Bruneton and Neyret 2008,
// "Precomputed Atmospheric Scattering" (revised 2017); tables and the sum over scatterings:
// Hillaire 2020, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique".
// Distances are kilometres, heights above the ground, coefficients per kilometre at linear Rec.709
// primaries.

#include "engine/core/jobs.h"
#include "engine/core/math.h"

#include <cstdint>
#include <vector>

namespace rushlight {

struct Medium {
    vec3 rayleigh;    ///< scattering
    float mie;        ///< scattering
    vec3 extinction;  ///< all scattering and absorption
};

class Atmosphere {
public:
    static constexpr float kGroundRadius = 6360;
    static constexpr float kTopRadius = 6460;

    /// `haze`: 1 is clear air; the density of the haze grows with it. `groundAlbedo` in [0, 1].
    Atmosphere(float haze, const vec3& groundAlbedo, JobSystem& jobs);

    Medium mediumAt(float height) const;

    /// Share of the light that gets from the top of the atmosphere to a height, from a direction
    /// whose cosine with the zenith is given; black where the planet is in between.
    vec3 transmittance(float height, float cosZenith) const;

    /// Radiance that comes to `height` from `direction` (unit, y up), for a sun of illuminance 1 at
    /// the top of the atmosphere towards `sun` (unit). Without the sun's disk; with the ground, lit
    /// by sun and sky.
    vec3 radiance(float height, const vec3& direction, const vec3& sun) const;

private:
    struct Table {
        uint32_t width = 0, height = 0;
        std::vector<vec3> texels;
        vec3 sample(float u, float v) const;  ///< bilinear, [0, 1] from the first texel's centre to
                                              ///< the last one's
    };
    vec3 march(float height, const vec3& direction, const vec3& sun, bool firstOrderAlone,
               vec3* unitScattering) const;
    void makeTransmittance(JobSystem& jobs);
    void makeMultipleScattering(JobSystem& jobs);
    vec3 multipleScattering(float height, float cosSun) const;

    float haze_;
    vec3 groundAlbedo_;
    Table transmittance_;
    Table multiple_;  ///< radiance of light scattered twice and more, the same from all around
};

}  // namespace rushlight

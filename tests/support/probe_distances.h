#pragma once
// Distances that irradiance probes see, at random, as smooth as those of walls are.

#include "interop/irradiance_volume.h"
#include "renderer/lighting/irradiance_volume.h"
#include "tests/support/random.h"

namespace rushlight {

/// For one probe: from `nearest` to `farthest` metres, further to one side than to the other.
inline void seeSmoothly(IrradianceVolume& volume, uint32_t probe, Random& random, float nearest,
                        float farthest) {
    const vec3 side = random.direction();
    const float middle = random.uniform(nearest, farthest) / 1.5f;
    for (uint32_t t = 0; t < kProbeDistances; ++t) {
        const vec2 texel(t % RL_PROBE_TEXELS, t / RL_PROBE_TEXELS);
        const vec3 d = interop::decodeOctahedral((texel + 0.5f) * (2.0f / RL_PROBE_TEXELS) - 1.0f);
        const float distance = middle * (1 + 0.5f * glm::dot(side, d));
        volume.setDistance(probe, t, {distance, 0.2f * distance});
    }
}

}  // namespace rushlight

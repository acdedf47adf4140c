#pragma once
// A clear sky as light: the sun that shines through it, the environment around, and the exposure
// that suits both.

#include "engine/core/jobs.h"
#include "engine/core/result.h"
#include "renderer/frame/frame_input.h"

#include <vector>

namespace rushlight {

struct SkyDesc {
    vec3 sunDirection{0, 1, 0};  ///< unit, world space, towards the sun; y up; below the horizon it
                                 ///< is dusk or night
    float turbidity = 2;  ///< haze, 1 to 10: 2 is clear, 4 hazy. Extinction of all air over that of
                          ///< molecules
    vec3 groundAlbedo{0.3f};  ///< [0, 1]
    float height = 100;       ///< metres above the sea that the eye is at, 0 to 50,000
    uint32_t width = 512;     ///< of the picture; it is half as high; 16 to 4,096
};

struct Sky {
    uint32_t width = 0, height = 0;
    std::vector<vec3> pixels;  ///< cd/m², as EnvironmentDesc takes them; without the sun's disk
    DirectionalLight sun;      ///< lux; black when it is below the horizon
    vec3 sunRadiance{0};       ///< cd/m² of the disk
    vec3 skyIlluminance{0};    ///< lux on level ground, of the sky alone
    float exposureValue = 0;   ///< EV100 at which level ground is as bright in the picture as its
                               ///< albedo

    EnvironmentDesc environment(std::string_view label) const {
        return {label, width, height, pixels};
    }
};

/// The radius of the sun's disk, radians.
inline constexpr float kSunAngularRadius = 0.004675f;

/// The same bytes for any number of threads; about 0.1 s of one thread at the size given above. An
/// Error names the value that is out of its range.
Result<Sky> makeSky(const SkyDesc& desc, JobSystem& jobs);

}  // namespace rushlight

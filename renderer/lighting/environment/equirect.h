#pragma once
// The equirectangular source of an environment: u = atan2(z, x) / 2 pi + 1/2, v from the top = 1/2
// - asin(y) / pi.

#include "engine/core/jobs.h"
#include "engine/core/math.h"
#include "renderer/frame/frame_input.h"
#include "renderer/lighting/environment/cube_image.h"

#include <cstdint>
#include <vector>

namespace rushlight {

struct Equirect {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<vec4> texels;

    /// Bilinear; wraps around in u.
    vec4 sample(const vec3& unit) const;
};

/// Solid angle of each texel of row `y` in an image of width x height.
float equirectTexelSolidAngle(uint32_t y, uint32_t width, uint32_t height);
/// Unit direction at texture coordinates (u, v), v from the top.
vec3 equirectDirection(float u, float v);
/// `pixel` with what is negative or not finite made black.
vec3 cleanRadiance(const vec3& pixel);

/// A clean copy, made smaller by whole factors (averaged by solid angle) until it is at most
/// `maxWidth` wide.
Equirect makeEquirect(const EnvironmentDesc& desc, uint32_t maxWidth, JobSystem& jobs);

CubeLevel projectToCube(const Equirect& source, uint32_t size, JobSystem& jobs);

}  // namespace rushlight

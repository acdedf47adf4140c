#pragma once
// Cube maps on the CPU, in GL's face order and orientation (OpenGL 4.5 core, table 8.19).

#include "engine/core/jobs.h"
#include "engine/core/math.h"

#include <cstdint>
#include <vector>

namespace rushlight {

/// A place on a cube: face 0..5 = +x -x +y -y +z -z; s and t in [-1, 1], the texel row 0 at t = -1.
struct CubePoint {
    uint32_t face;
    float s;
    float t;
};

/// Direction (not unit) of a point on a face; s and t may be beyond [-1, 1].
vec3 cubeDirection(uint32_t face, float s, float t);
CubePoint cubePoint(const vec3& direction);

/// Solid angle of texel (x, y) of a face with `size` texels a side; those of all six faces add up
/// to 4 pi.
float cubeTexelSolidAngle(uint32_t x, uint32_t y, uint32_t size);

/// One level of a cube map of linear radiance. Each face has a border of one texel that repeats its
/// neighbours, so that bilinear filtering has no seams.
class CubeLevel {
public:
    CubeLevel() = default;
    explicit CubeLevel(uint32_t size);

    uint32_t size() const { return size_; }
    vec4& at(uint32_t face, uint32_t x, uint32_t y) { return texels_[index(face, x + 1, y + 1)]; }
    const vec4& at(uint32_t face, uint32_t x, uint32_t y) const {
        return texels_[index(face, x + 1, y + 1)];
    }

    /// To be called after the texels are written and before `sample`.
    void fillBorders();

    /// Bilinear radiance; xyz.
    vec4 sample(const vec3& direction) const;

private:
    size_t index(uint32_t face, uint32_t column, uint32_t row) const {
        return (size_t(face) * stride_ + row) * stride_ + column;
    }
    uint32_t size_ = 0;
    uint32_t stride_ = 0;
    std::vector<vec4> texels_;
};

/// Half the size, each texel the average of four by solid angle: the energy stays.
CubeLevel halveCube(const CubeLevel& source, JobSystem& jobs);

/// Bilinear samples: for enlarging.
CubeLevel resizeCube(const CubeLevel& source, uint32_t size, JobSystem& jobs);

}  // namespace rushlight

#pragma once

#include "engine/core/hash.h"
#include "engine/core/math.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rushlight {

/// The random numbers of one path: a function of its seed alone. O'Neill, PCG32 (pcg-random.org),
/// 2014.
class RayRandom {
public:
    explicit RayRandom(uint64_t seed) : state_(mixBits(seed + 0x9e3779b97f4a7c15ull)) {}

    float next() {
        const uint64_t old = state_;
        state_ = old * 6364136223846793005u + 1442695040888963407u;
        const uint32_t mixed = uint32_t((old >> 18 ^ old) >> 27);
        const uint32_t turn = uint32_t(old >> 59);
        return float((mixed >> turn | mixed << ((32 - turn) & 31)) >> 8) * 0x1p-24f;
    }

private:
    uint64_t state_;
};

/// Direction `i` of `count`, spread evenly over the sphere: a spherical Fibonacci lattice. `turn`
/// in [0, 1) rotates it about the z axis. Keinert et al. 2015, "Spherical Fibonacci Mapping".
inline vec3 fibonacciDirection(uint32_t i, uint32_t count, float turn) {
    constexpr float kGolden = 0.61803398875f;
    const float at = float(i) * kGolden + turn;
    const float phi = 2 * kPi * (at - std::floor(at));
    const float z = 1 - (2 * float(i) + 1) / float(count);
    const float ring = std::sqrt(std::max(0.0f, 1 - z * z));
    return {ring * std::cos(phi), ring * std::sin(phi), z};
}

}  // namespace rushlight

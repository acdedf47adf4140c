#pragma once

#include "engine/core/math.h"

#include <cstdint>

namespace rushlight {

/// Numbers that are the same on every machine: O'Neill, PCG32 (pcg-random.org), 2014.
class Random {
public:
    explicit Random(uint64_t seed) : state_(seed * 2 + 1) { next(); }

    uint32_t next() {
        const uint64_t old = state_;
        state_ = old * 6364136223846793005u + 1442695040888963407u;
        const uint32_t mixed = uint32_t((old >> 18 ^ old) >> 27);
        const uint32_t turn = uint32_t(old >> 59);
        return mixed >> turn | mixed << ((32 - turn) & 31);
    }
    uint32_t below(uint32_t end) { return uint32_t(uint64_t(next()) * end >> 32); }
    float uniform(float low, float high) {
        return low + (high - low) * (float(next() >> 8) * 0x1p-24f);
    }
    vec3 vector(float low, float high) {
        const float x = uniform(low, high), y = uniform(low, high);
        return {x, y, uniform(low, high)};
    }
    vec3 direction() {
        for (;;)
            if (const vec3 v = vector(-1, 1); glm::dot(v, v) > 0.01f && glm::dot(v, v) < 1)
                return glm::normalize(v);
    }

private:
    uint64_t state_;
};

}  // namespace rushlight

#pragma once
// Boxes against view volumes, 64 at a time, by SIMD that is chosen at run time (Highway).

#include "renderer/geometry/view_math.h"

#include <array>
#include <cstdint>

namespace rushlight {

inline constexpr uint32_t kBlockSize = 64;

/// Up to 64 world-space boxes by component: `low[axis][i]`, `high[axis][i]`. A 64-bit mask that
/// goes with it says which are in use.
struct alignas(64) BoxBlock {
    float low[3][kBlockSize] = {};
    float high[3][kBlockSize] = {};

    void set(uint32_t i, const Aabb& box) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis][i] = box.low[axis];
            high[axis][i] = box.high[axis];
        }
    }
    Aabb get(uint32_t i) const {
        return {{low[0][i], low[1][i], low[2][i]}, {high[0][i], high[1][i], high[2][i]}};
    }
};

/// A convex volume: the points on the inner side of every plane. None: all of space.
struct CullVolume {
    static constexpr uint32_t kMaxPlanes = 24;

    std::array<Plane, kMaxPlanes> planes;
    uint32_t count = 0;

    /// A plane with no normal accepts everything and is dropped.
    void add(const Plane& plane);
    void add(const Frustum& frustum);
};

/// The volume that `seen` sweeps when it is moved without end along `direction` (unit), each plane
/// moved outwards by `margin` metres: everything whose shadow, cast against `direction`, can fall
/// into `seen`, or into what lies up to `behind` metres against `direction` from it. Planes are
/// added to `volume`.
void addSwept(CullVolume& volume, const Frustum& seen, const vec3& direction, float margin,
              float behind = 0);

/// Bit i of `touching`: box i may be in the volume (never missing one that is). Bit i of `inside`:
/// no part of it is outside.
struct BlockMasks {
    uint64_t touching = 0;
    uint64_t inside = 0;
};
BlockMasks testBoxes(const BoxBlock& boxes, const CullVolume& volume);

/// `touching` alone, for half the work.
uint64_t touchingBoxes(const BoxBlock& boxes, const CullVolume& volume);

}  // namespace rushlight

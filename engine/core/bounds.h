#pragma once

#include "engine/core/math.h"

#include <array>
#include <limits>

namespace rushlight {

/// Axis-aligned box. A default-constructed box is empty: `low > high`, and growing it works.
struct Aabb {
    vec3 low{std::numeric_limits<float>::max()};
    vec3 high{std::numeric_limits<float>::lowest()};

    bool isEmpty() const { return low.x > high.x || low.y > high.y || low.z > high.z; }
    vec3 center() const { return 0.5f * (low + high); }
    vec3 halfExtent() const { return 0.5f * (high - low); }

    void grow(const vec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    void grow(const Aabb& b) {
        low = glm::min(low, b.low);
        high = glm::max(high, b.high);
    }
};

/// The box around a transformed box. Arvo, "Transforming Axis-Aligned Bounding Boxes", Graphics
/// Gems, 1990.
inline Aabb transformAabb(const mat4x3& m, const Aabb& box) {
    const vec3 center = transformPoint(m, box.center());
    const vec3 half = box.halfExtent();
    const vec3 extent = glm::abs(m[0]) * half.x + glm::abs(m[1]) * half.y + glm::abs(m[2]) * half.z;
    return {center - extent, center + extent};
}

}  // namespace rushlight

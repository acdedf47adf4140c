#pragma once
// Small collision levels made of boxes and slabs.

#include "engine/physics/triangle_grid.h"

#include <vector>

namespace rushlight::test {

using Triangles = std::vector<CollisionTriangle>;

inline void addQuad(Triangles& to, vec3 a, vec3 b, vec3 c, vec3 d) {
    to.push_back({{a, b, c}});
    to.push_back({{a, c, d}});
}

/// Level ground of `half` metres to every side, at height y.
inline void addFloor(Triangles& to, float half, float y = 0) {
    addQuad(to, {-half, y, half}, {half, y, half}, {half, y, -half}, {-half, y, -half});
}

inline void addBox(Triangles& to, vec3 low, vec3 high) {
    const auto at = [&](int x, int y, int z) {
        return vec3(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
    };
    addQuad(to, at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
    addQuad(to, at(1, 0, 0), at(0, 0, 0), at(0, 1, 0), at(1, 1, 0));
    addQuad(to, at(1, 0, 1), at(1, 0, 0), at(1, 1, 0), at(1, 1, 1));
    addQuad(to, at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));
    addQuad(to, at(0, 1, 1), at(1, 1, 1), at(1, 1, 0), at(0, 1, 0));
    addQuad(to, at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));
}

}  // namespace rushlight::test

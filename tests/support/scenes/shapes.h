#pragma once
// Small meshes for tests.

#include "renderer/frame/frame_input.h"

#include <vector>

namespace rushlight {

struct Shape {
    std::vector<vec3> positions;
    std::vector<uint32_t> indices;

    MeshDesc desc(std::string_view label = "shape") const {
        MeshDesc mesh;
        mesh.label = label;
        mesh.positions = positions;
        mesh.indices = indices;
        return mesh;
    }
};

/// From -1 to 1, each side with corners of its own; `sides` from 1 to 6 of them, 6 being closed.
inline Shape makeCube(uint32_t sides = 6) {
    Shape cube;
    for (uint32_t side = 0; side < sides; ++side) {
        const int axis = int(side / 2);
        vec3 n(0), u(0), v(0);
        n[axis] = side % 2 ? -1.0f : 1.0f;
        u[(axis + 1) % 3] = side % 2 ? -1.0f : 1.0f;
        v[(axis + 2) % 3] = 1;
        const uint32_t first = uint32_t(cube.positions.size());
        for (vec3 corner : {n - u - v, n + u - v, n + u + v, n - u + v})
            cube.positions.push_back(corner);
        for (uint32_t i : {0, 1, 2, 0, 2, 3}) cube.indices.push_back(first + i);
    }
    return cube;
}

/// Unit radius, its poles and its seam welded only by position.
inline Shape makeSphere(uint32_t rings, uint32_t segments) {
    Shape sphere;
    for (uint32_t r = 0; r <= rings; ++r)
        for (uint32_t s = 0; s <= segments; ++s) {
            const float latitude = kPi * float(r) / float(rings);
            const float longitude = 2 * kPi * float(s % segments) / float(segments);
            const float ring = r == 0 || r == rings ? 0 : std::sin(latitude);
            sphere.positions.push_back({ring * std::cos(longitude),
                                        r == rings ? -1 : std::cos(latitude),
                                        ring * std::sin(longitude)});
        }
    for (uint32_t r = 0; r < rings; ++r)
        for (uint32_t s = 0; s < segments; ++s) {
            const uint32_t a = r * (segments + 1) + s, b = a + segments + 1;
            for (uint32_t i : {a, a + 1, b, a + 1, b + 1, b}) sphere.indices.push_back(i);
        }
    return sphere;
}

}  // namespace rushlight

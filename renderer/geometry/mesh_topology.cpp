#include "renderer/geometry/mesh_topology.h"

#include <algorithm>

#include <meshoptimizer.h>

namespace rushlight {

std::vector<uint32_t> placesOf(std::span<const vec3> positions) {
    if (positions.empty()) return {};
    const float step = meshopt_simplifyScale(&positions[0].x, positions.size(), sizeof(vec3)) *
                       0x1p-20f;
    std::vector<vec3> rounded(positions.begin(), positions.end());
    if (step > 0)
        for (vec3& p : rounded) p = glm::round(p / step) + 0.0f;  // no negative zeros
    std::vector<uint32_t> places(positions.size());
    meshopt_generateVertexRemap(places.data(), nullptr, places.size(), rounded.data(),
                                rounded.size(), sizeof(vec3));
    return places;
}

bool isClosed(std::span<const vec3> positions, std::span<const uint32_t> indices) {
    const std::vector<uint32_t> places = placesOf(positions);
    // A directed edge a->b counts as +1 under the key (min, max) when a < b, else -1: the sums must
    // all be zero.
    std::vector<uint64_t> forward, backward;
    forward.reserve(indices.size() / 2 + 1);
    backward.reserve(indices.size() / 2 + 1);
    for (size_t i = 0; i < indices.size(); i += 3)
        for (size_t k = 0; k < 3; ++k) {
            const uint64_t a = places[indices[i + k]], b = places[indices[i + (k + 1) % 3]];
            if (a == b) continue;
            if (a < b)
                forward.push_back(a << 32 | b);
            else
                backward.push_back(b << 32 | a);
        }
    if (forward.size() != backward.size()) return false;
    std::sort(forward.begin(), forward.end());
    std::sort(backward.begin(), backward.end());
    return forward == backward;
}

}  // namespace rushlight

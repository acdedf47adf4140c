#pragma once
// A mesh prepared to hide what is behind it: positions welded, edges paired. Made once a mesh, not
// once a frame.

#include "engine/core/math.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rushlight {

/// Coordinates by component, padded for vector loads. Corners with the same position are one
/// vertex, since the GPU puts them into the same place, so that surfaces are known to be joined
/// across seams of normals and uv.
struct OccluderMesh {
    static constexpr uint32_t kNone = ~0u;

    uint32_t vertexCount = 0;
    std::vector<float> x, y, z;        ///< vertexCount and padding
    std::vector<uint32_t> corners;     ///< three a triangle
    std::vector<uint32_t> neighbours;  ///< of the edge from each corner to the next: a triangle or
                                       ///< kNone
    vec3 reach{0};                     ///< greatest |x|, |y|, |z|

    uint32_t triangleCount() const { return uint32_t(corners.size() / 3); }
};

/// Triangles with indices out of range, with two corners in one place or with positions that are
/// not finite are left out. An edge's neighbour is the triangle that has the same edge the other
/// way round; each is paired once.
OccluderMesh makeOccluderMesh(std::span<const vec3> positions, std::span<const uint32_t> indices);

}  // namespace rushlight

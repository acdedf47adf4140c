#pragma once
// A mesh's coarse levels on the CPU, positions alone, for what rasterises or intersects there.

#include "renderer/geometry/mesh_lods.h"

#include <span>
#include <vector>

namespace rushlight {

struct CpuMesh {
    static constexpr uint32_t kMostTriangles = 2048;  ///< of a level that is kept

    std::vector<vec3> positions;     ///< local space; only those the levels use
    std::vector<uint32_t> vertices;  ///< as `positions`: which vertex of the mesh each one follows
    std::vector<uint32_t> indices;   ///< of all kept levels, into `positions`
    std::array<MeshLod, kMaxLods> lods;  ///< `firstIndex` into `indices`; the mesh's numbering,
                                         ///< those not kept are empty
    uint32_t firstLod = 0;               ///< the finest that is kept
    uint32_t lodCount = 0;               ///< the mesh's; firstLod < lodCount

    std::span<const uint32_t> level(uint32_t lod) const {
        return std::span(indices).subspan(lods[lod].firstIndex, lods[lod].indexCount);
    }
    void movePositions(std::span<const vec3> meshPositions) {
        for (size_t i = 0; i < vertices.size(); ++i) positions[i] = meshPositions[vertices[i]];
    }
};

/// Of a mesh whose level 0 is `indices`; with no levels (`lodCount` 0) where all have more than
/// kMostTriangles.
CpuMesh makeCpuMesh(std::span<const vec3> positions, std::span<const uint32_t> indices,
                    const LodChain& chain);

}  // namespace rushlight

#include "renderer/geometry/cpu_mesh.h"

namespace rushlight {

CpuMesh makeCpuMesh(std::span<const vec3> positions, std::span<const uint32_t> indices,
                    const LodChain& chain) {
    CpuMesh out;
    while (out.firstLod < chain.count &&
           chain.lods[out.firstLod].indexCount > CpuMesh::kMostTriangles * 3)
        ++out.firstLod;
    if (out.firstLod == chain.count) return {};
    out.lodCount = chain.count;
    constexpr uint32_t kNone = ~0u;
    std::vector<uint32_t> local(positions.size() + chain.moved.size(), kNone);
    for (uint32_t lod = out.firstLod; lod < chain.count; ++lod) {
        const MeshLod& from = chain.lods[lod];
        const auto level = lod == 0
                               ? indices
                               : std::span(chain.indices)
                                     .subspan(from.firstIndex - indices.size(), from.indexCount);
        out.lods[lod] = {uint32_t(out.indices.size()), from.indexCount, from.error};
        for (uint32_t vertex : level) {
            if (local[vertex] == kNone) {
                local[vertex] = uint32_t(out.vertices.size());
                const MovedVertex moved = vertex < positions.size()
                                              ? MovedVertex{vertex, vec3(0)}
                                              : chain.moved[vertex - positions.size()];
                out.vertices.push_back(moved.source);
                out.positions.push_back(positions[moved.source] + moved.offset);
            }
            out.indices.push_back(local[vertex]);
        }
    }
    return out;
}

}  // namespace rushlight

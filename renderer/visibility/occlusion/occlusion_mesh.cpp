#include "renderer/visibility/occlusion/occlusion_mesh.h"

#include "renderer/visibility/occlusion/occlusion_types.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

/// The number of each position's vertex after welding; kNone for what is not finite.
std::vector<uint32_t> weld(std::span<const vec3> positions, OccluderMesh& mesh) {
    std::vector<uint32_t> order;
    for (uint32_t i = 0; i < positions.size(); ++i)
        if (isFinite(positions[i])) order.push_back(i);
    const auto less = [&](uint32_t a, uint32_t b) {
        const vec3 &p = positions[a], &q = positions[b];
        if (p.x != q.x) return p.x < q.x;
        if (p.y != q.y) return p.y < q.y;
        return p.z < q.z;
    };
    std::ranges::stable_sort(order, less);
    std::vector<uint32_t> welded(positions.size(), OccluderMesh::kNone);
    for (size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || less(order[i - 1], order[i])) {
            const vec3& p = positions[order[i]];
            mesh.x.push_back(p.x);
            mesh.y.push_back(p.y);
            mesh.z.push_back(p.z);
            mesh.reach = glm::max(mesh.reach, glm::abs(p));
        }
        welded[order[i]] = uint32_t(mesh.x.size() - 1);
    }
    return welded;
}

struct Edge {
    uint64_t ends;    ///< the lesser vertex in the upper half
    uint32_t corner;  ///< where it begins
    bool descends;
};

void pairEdges(OccluderMesh& mesh) {
    std::vector<Edge> edges;
    edges.reserve(mesh.corners.size());
    for (uint32_t c = 0; c < mesh.corners.size(); ++c) {
        const uint32_t a = mesh.corners[c], b = mesh.corners[c % 3 == 2 ? c - 2 : c + 1];
        edges.push_back({uint64_t(std::min(a, b)) << 32 | std::max(a, b), c, a > b});
    }
    std::ranges::sort(edges, [](const Edge& a, const Edge& b) {
        if (a.ends != b.ends) return a.ends < b.ends;
        if (a.descends != b.descends) return b.descends;
        return a.corner < b.corner;
    });
    mesh.neighbours.assign(mesh.corners.size(), OccluderMesh::kNone);
    for (auto run = edges.begin(); run != edges.end();) {
        const auto end = std::find_if(run, edges.end(),
                                      [&](const Edge& e) { return e.ends != run->ends; });
        auto down = std::find_if(run, end, [](const Edge& e) { return e.descends; });
        for (auto up = run; up != end && !up->descends && down != end; ++up, ++down) {
            mesh.neighbours[up->corner] = down->corner / 3;
            mesh.neighbours[down->corner] = up->corner / 3;
        }
        run = end;
    }
}

}  // namespace

OccluderMesh makeOccluderMesh(std::span<const vec3> positions, std::span<const uint32_t> indices) {
    OccluderMesh mesh;
    const std::vector<uint32_t> welded = weld(positions, mesh);
    mesh.vertexCount = uint32_t(mesh.x.size());
    for (size_t i = 0; i + 2 < indices.size(); i += 3) {
        uint32_t v[3];
        bool good = true;
        for (size_t k = 0; k < 3; ++k) {
            v[k] = indices[i + k] < welded.size() ? welded[indices[i + k]] : OccluderMesh::kNone;
            good &= v[k] != OccluderMesh::kNone;
        }
        if (good && v[0] != v[1] && v[1] != v[2] && v[2] != v[0])
            mesh.corners.insert(mesh.corners.end(), v, v + 3);
    }
    pairEdges(mesh);
    const size_t padded = paddedToLanes(mesh.vertexCount);
    for (std::vector<float>* values : {&mesh.x, &mesh.y, &mesh.z}) values->resize(padded, 0);
    return mesh;
}

}  // namespace rushlight

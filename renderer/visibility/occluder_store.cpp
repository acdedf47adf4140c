#include "renderer/visibility/occluder_store.h"

namespace rushlight {
namespace {

constexpr uint32_t kMostChanges = 2;

}  // namespace

void OccluderStore::noteChanges(std::span<const MeshHandle> meshes) {
    for (MeshHandle mesh : meshes) {
        if (mesh.index() >= entries_.size()) continue;
        Entry& entry = entries_[mesh.index()];
        if (entry.generation == mesh.generation()) ++entry.changes;
        for (auto& lod : entry.lods) lod.reset();
    }
}

const OccluderMesh* OccluderStore::get(MeshHandle handle, uint32_t lod,
                                       const GeometryStore& geometry) {
    if (handle.index() >= entries_.size()) entries_.resize(handle.index() + 1);
    Entry& entry = entries_[handle.index()];
    if (entry.generation != handle.generation()) entry = {handle.generation(), 0, {}};
    if (entry.changes > kMostChanges) return nullptr;
    if (entry.lods[lod]) return entry.lods[lod].get();
    const CpuMesh* mesh = geometry.cpuMesh(handle);
    if (!mesh || lod < mesh->firstLod) return nullptr;
    entry.lods[lod] = std::make_unique<OccluderMesh>(
        makeOccluderMesh(mesh->positions, mesh->level(lod)));
    return entry.lods[lod].get();
}

}  // namespace rushlight

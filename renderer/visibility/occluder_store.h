#pragma once
// Meshes as occluders, made when one is first wanted. Used on the renderer's thread; get() returns
// what stays in place until noteChanges().

#include "renderer/resources/geometry_store.h"
#include "renderer/visibility/occlusion/occlusion_mesh.h"

#include <memory>
#include <vector>

namespace rushlight {

class OccluderStore {
public:
    /// Forgets meshes that changed. One whose vertices are updated again and again is no occluder
    /// any more: to make it ready would cost more than it hides.
    void noteChanges(std::span<const MeshHandle> meshes);

    /// Null where the CPU does not keep that level, or the mesh is not to be used.
    const OccluderMesh* get(MeshHandle mesh, uint32_t lod, const GeometryStore& geometry);

private:
    struct Entry {
        uint32_t generation = 0;
        uint32_t changes = 0;
        std::array<std::unique_ptr<OccluderMesh>, kMaxLods> lods;
    };
    std::vector<Entry> entries_;  ///< by mesh index
};

}  // namespace rushlight

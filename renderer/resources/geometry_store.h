#pragma once
// Meshes in shared vertex and index buffers, so that one multi-draw can reach them all.

#include "engine/core/bounds.h"
#include "engine/core/jobs.h"
#include "renderer/frame/frame_input.h"
#include "renderer/geometry/cpu_mesh.h"
#include "renderer/geometry/facing_groups.h"
#include "renderer/geometry/mesh_lods.h"
#include "renderer/resources/range_allocator.h"
#include "renderer/rhi/device.h"

#include <array>
#include <vector>

namespace rushlight {

struct GpuMesh {
    Aabb bounds;              ///< local space, of all levels
    uint32_t firstIndex = 0;  ///< of level 0 in the order it was given in, for what is blended; the
                              ///< levels follow
    uint32_t indexCount = 0;  ///< of level 0
    uint32_t firstVertex = 0;
    uint32_t vertexCount = 0;
    uint32_t movedCount = 0;               ///< of LodChain::moved, after the mesh's vertices
    std::array<MeshLod, kMaxLods> lods;    ///< finest first; `firstIndex` in the shared buffer
    uint32_t lodCount = 0;                 ///< at least 1
    uint32_t groupedLods = 0;              ///< so many of the finest levels are sorted by facing
    const FacingGroups* facing = nullptr;  ///< of the grouped levels
    bool extended = false;                 ///< has VertexExtra, lives in the extended streams
    bool hasTangents = false;
    bool closed = false;  ///< every edge has its opposite: back faces never decide a depth
};

/// Vertex streams of one layout.
struct VertexStreams {
    BufferHandle positions;
    BufferHandle surfaces;
    BufferHandle extras;  ///< none in the standard layout
};

class GeometryStore {
public:
    explicit GeometryStore(Device& device) : device_(device) {}
    ~GeometryStore();
    GeometryStore(const GeometryStore&) = delete;
    GeometryStore& operator=(const GeometryStore&) = delete;

    Result<MeshHandle> create(const MeshDesc&);
    /// Many at once, their levels of detail made on all of the job system's threads. `handles` is
    /// as long as `descs`. An Error names the first bad one, and then none is made.
    Result<void> create(std::span<const MeshDesc> descs, std::span<MeshHandle> handles, JobSystem&);
    /// Moves the vertices. The levels stay: their triangles and errors are those of the vertices at
    /// creation, but what was moved to balance them lies on the surface from now on.
    Result<void> update(MeshHandle, const MeshDesc&);
    void destroy(MeshHandle);
    const GpuMesh* find(MeshHandle mesh) const { return meshes_.find(mesh); }
    void prefetch(MeshHandle mesh) const { meshes_.prefetch(mesh); }

    /// Null for a stale handle and for a mesh all of whose levels are too large to be kept. Good
    /// until meshes are created or destroyed.
    const CpuMesh* cpuMesh(MeshHandle mesh) const;

    /// What was created, updated or destroyed since clearChanges(); a destroyed mesh's handle is
    /// stale.
    std::span<const MeshHandle> changedMeshes() const { return changes_; }
    void clearChanges();

    const VertexStreams& streams(bool extended) const { return families_[extended].streams; }
    BufferHandle indices() const { return indices_; }

private:
    struct Family {
        VertexStreams streams;
        RangeAllocator vertices;
        uint32_t capacity = 0;
    };
    Result<void> reserveVertices(bool extended);
    Result<void> reserveIndices();
    Result<void> grow(BufferHandle& buffer, const char* label, BufferUsage usage, uint64_t oldBytes,
                      uint64_t newBytes);
    struct Prepared;
    static Prepared prepare(const MeshDesc&);
    Result<MeshHandle> insert(Prepared&&, const MeshDesc&);
    /// `places` of the mesh's vertices and those moved, in the streams.
    void upload(const GpuMesh&, const MeshDesc&, std::span<const MovedVertex> moved,
                std::span<const uint32_t> places);
    void noteChange(MeshHandle);

    struct Side {  // beside a GpuMesh, by handle index; apart from it, as frames walk the GpuMeshes
        CpuMesh cpu;
        std::vector<MovedVertex> moved;
        std::vector<FacingGroups> facing;
        std::vector<uint32_t> places;
        bool changed = false;
    };
    Device& device_;
    Pool<GpuMesh, MeshTag> meshes_;
    std::vector<Side> sides_;
    std::vector<MeshHandle> changes_;
    std::array<Family, 2> families_;
    BufferHandle indices_;
    RangeAllocator indexRanges_;
    uint32_t indexCapacity_ = 0;
};

}  // namespace rushlight

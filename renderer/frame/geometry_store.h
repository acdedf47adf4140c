#pragma once
// Meshes in shared vertex and index buffers, so that one multi-draw can reach them all.

#include "engine/core/bounds.h"
#include "renderer/backend/device.h"
#include "renderer/frame/frame_input.h"
#include "renderer/frame/range_allocator.h"

#include <array>
#include <vector>

namespace rushlight {

struct GpuMesh {
    Aabb bounds;  ///< local space
    uint32_t firstIndex = 0;
    uint32_t indexCount = 0;
    uint32_t firstVertex = 0;
    uint32_t vertexCount = 0;
    bool extended = false;     ///< has VertexExtra, lives in the extended streams
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
    Result<void> update(MeshHandle, const MeshDesc&);
    void destroy(MeshHandle);
    const GpuMesh* find(MeshHandle mesh) const { return meshes_.find(mesh); }

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
    Result<void> grow(BufferHandle& buffer, const char* label, BufferUsage usage,
                      uint64_t oldBytes, uint64_t newBytes);
    void upload(const GpuMesh&, const MeshDesc&);

    Device& device_;
    Pool<GpuMesh, MeshTag> meshes_;
    std::array<Family, 2> families_;
    BufferHandle indices_;
    RangeAllocator indexRanges_;
    uint32_t indexCapacity_ = 0;
};

/// True when every directed edge of the position-welded triangles has its opposite.
bool isClosed(std::span<const vec3> positions, std::span<const uint32_t> indices);

}  // namespace rushlight

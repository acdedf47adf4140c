#pragma once
// The draws of one view: sorted, merged into instanced draws and multi-draw batches, and their data
// for the GPU.

#include "renderer/resources/geometry_store.h"
#include "renderer/resources/material_store.h"
#include "renderer/rhi/commands/command_buffer.h"
#include "renderer/visibility/view_motion.h"

#include <span>
#include <vector>

namespace rushlight {

/// An object that a view draws, and how.
struct VisibleItem {
    uint64_t key = 0;         ///< see opaqueKey, shadowKey and blendKey
    uint32_t object = 0;      ///< of FrameWorlds; decides between equal keys
    uint32_t flags : 24 = 0;  ///< surface flags of the program that draws it
    uint32_t lod : 8 = 0;     ///< of GpuMesh::lods
};
static_assert(sizeof(VisibleItem) == 16);

/// The worlds of a frame: the host's, which may be none, and that of FrameInput::instances.
///
///     object    31      30           0
///            [ world ][    slot      ]
struct FrameWorlds {
    std::array<InstanceWorld*, 2> worlds{};
    const ViewMotion* motion = nullptr;  ///< of the host's world, as the view saw it; null: still

    static uint32_t object(uint32_t world, uint32_t slot) { return world << 31 | slot; }
    InstanceWorld& world(uint32_t object) const { return *worlds[object >> 31]; }
    InstanceRecord& record(uint32_t object) const {
        return world(object).record(object & 0x7fffffff);
    }
    /// kMoving where the view saw the object elsewhere.
    uint32_t motionFlag(uint32_t object) const;
    /// Where the view saw what has that flag.
    const mat4x3& previousTransform(uint32_t object) const;
    /// Of an item that comes soon; nothing beyond the end.
    void prefetch(std::span<const VisibleItem> items, size_t index) const {
        constexpr size_t kAhead = 12;
        if (index + kAhead >= items.size()) return;
        const uint32_t object = items[index + kAhead].object;
        world(object).prefetch(object & 0x7fffffff);
    }
    Aabb bounds() const;  ///< of everything; empty when there is nothing
    /// f(flags) of every combination that InstanceWorld::variants() has; one may come twice.
    template <class F>
    void forEachVariant(F&& f) const {
        for (const InstanceWorld* world : worlds)
            if (world)
                for (uint32_t flags : world->variants()) f(flags);
    }
};

uint64_t opaqueKey(uint32_t flags, uint32_t textureSet, uint32_t mesh, uint32_t lod, float depth);
uint64_t shadowKey(uint32_t flags, uint32_t textureSet, uint32_t mesh, uint32_t lod);
uint64_t blendKey(float depth);

/// Draws that share a pipeline, textures and vertex streams: one multi-draw.
struct DrawBatch {
    uint32_t surfaceFlags = 0;
    uint32_t textureSet = 0;
    bool extended = false;
    bool moving = false;
    uint32_t firstDraw = 0;
    uint32_t drawCount = 0;
    uint32_t triangleCount = 0;
    PipelineHandle pipeline;  ///< set by the pass
};

/// What one view draws. Memory is kept from frame to frame. Lists may be worked on at the same
/// time.
class DrawList {
public:
    static constexpr uint32_t kItemsPerJob = 512;

    std::vector<VisibleItem> items;

    /// What the items have in common.
    struct Kind {
        bool casters = false;  ///< materials only matter where alpha cuts or light goes through
        bool blended = false;  ///< triangles keep the order that they were given in
        FacingEye eye{0};  ///< triangles whose backs it sees are left out where backs are culled;
                           ///< all zero: none, as what that takes is more than shadow maps win by
                           ///< it
    };
    /// Sorts the items and forms batches.
    void arrange(const FrameWorlds& worlds, const GeometryStore& geometry, const Kind& kind);

    /// Of which objects are drawn in which state, and how. After arrange().
    uint64_t contentHash() const { return contentHash_; }

    /// Makes room in the data block; then fill() writes a range of the items' data, from any
    /// thread.
    void allocate(CommandBuffer& buffer);
    void fill(CommandBuffer& buffer, const FrameWorlds& worlds, uint32_t begin, uint32_t end) const;

    std::vector<DrawBatch> batches;
    BufferRange instanceRange;
    BufferRange movingRange;
    BufferRange commandRange;

private:
    void addDraws(const GpuMesh& mesh, uint32_t lod, uint32_t groups, uint32_t instance);
    void addDraw(const GpuMesh& mesh, uint32_t lod, bool asGiven, uint32_t instance);

    std::vector<VisibleItem> scratch_;
    std::vector<DrawIndexedCommand> draws_;
    std::vector<uint32_t> positions_;  ///< by item: its place in the stream of those that move, or
                                       ///< of the others
    uint32_t stillCount_ = 0, movingCount_ = 0;
    uint64_t contentHash_ = 0;
};

/// Binds a batch's streams and textures and issues its multi-draw.
struct DrawBinder {
    const GeometryStore* geometry = nullptr;
    const MaterialStore* materials = nullptr;

    void record(CommandBuffer& commands, const DrawList& list) const;
};

}  // namespace rushlight

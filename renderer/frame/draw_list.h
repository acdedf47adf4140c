#pragma once
// From instances to multi-draws: what a view sees, sorted, grouped and written into the frame's data block.

#include "renderer/commands/command_buffer.h"
#include "renderer/frame/geometry_store.h"
#include "renderer/frame/material_store.h"
#include "renderer/frame/view_math.h"

#include <span>
#include <vector>

namespace rushlight {

/// An instance with its handles resolved and its bounds in the world; `mesh` is null for one that is left out.
struct ResolvedInstance {
    vec3 center{0};
    vec3 halfExtent{0};
    const GpuMesh* mesh = nullptr;
    uint32_t surfaceFlags = 0;
    uint32_t textureSet = 0;
    uint32_t materialTexel = 0;
};

/// Looks up handles, checks transforms and bounds them, on all threads. `out` is as long as `instances`.
void resolveInstances(std::span<const Instance> instances, size_t previousTransformCount,
                      const GeometryStore& geometry, const MaterialStore& materials,
                      JobSystem& jobs, std::vector<ResolvedInstance>& out);

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

enum class DrawListKind : uint8_t {
    opaque,  ///< sorted by state, then front to back
    blend,   ///< back to front
    shadow,  ///< casters, materials ignored unless alpha-masked
    movingEmission,  ///< opaque surfaces that move and give off light
};

/// What one view draws. Memory is kept from frame to frame.
class DrawList {
public:
    /// Culls and sorts; touches nothing shared, so views can be gathered at the same time.
    /// `sees(center, halfExtent)` says whether a box is in the view.
    template <class Sees>
    void gather(DrawListKind kind, std::span<const Instance> instances,
                std::span<const ResolvedInstance> resolved, const vec3& eye, const vec3& forward,
                Sees&& sees) {
        begin(kind);
        for (uint32_t i = 0; i < resolved.size(); ++i) {
            const ResolvedInstance& r = resolved[i];
            if (!r.mesh || !belongs(instances[i].flags, r.surfaceFlags)) continue;
            if (sees(r.center, r.halfExtent)) add(i, instances[i], r, eye, forward);
        }
        end(resolved);
    }

    /// Makes room in the data block, then, separately so that lists can be filled at the same time, fills it.
    void allocate(CommandBuffer& buffer);
    void fill(CommandBuffer& buffer, std::span<const Instance> instances,
              std::span<const ResolvedInstance> resolved,
              std::span<const mat4x3> previousTransforms);

    uint32_t visibleCount() const { return uint32_t(items_.size()); }
    template <class F>
    void forEachVisible(F&& f) const {
        for (const Item& item : items_) f(item.instance);
    }
    uint64_t contentHash(const CommandBuffer& buffer) const;

    std::vector<DrawBatch> batches;
    BufferRange instanceRange;
    BufferRange movingRange;
    BufferRange commandRange;

private:
    struct Item {
        uint64_t key;
        uint32_t instance;
        uint32_t flags;
    };
    void begin(DrawListKind kind);
    bool belongs(uint32_t instanceFlags, uint32_t surfaceFlags) const;
    void add(uint32_t index, const Instance& instance, const ResolvedInstance& resolved,
             const vec3& eye, const vec3& forward);
    void end(std::span<const ResolvedInstance> resolved);
    void formBatches(std::span<const ResolvedInstance> resolved);

    DrawListKind kind_ = DrawListKind::opaque;
    std::vector<Item> items_;
    std::vector<DrawIndexedCommand> draws_;
    uint32_t stillCount_ = 0, movingCount_ = 0;
};

/// Binds a batch's streams and textures and issues its multi-draw.
struct DrawBinder {
    const GeometryStore* geometry = nullptr;
    const MaterialStore* materials = nullptr;

    void record(CommandBuffer& commands, const DrawList& list) const;
};

}  // namespace rushlight

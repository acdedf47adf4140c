#pragma once

#include "renderer/plan/frame_plan.h"
#include "renderer/rhi/device.h"
#include "renderer/visibility/draw_list.h"

#include <string_view>
#include <vector>

namespace rushlight {

/// What the pipelines of one surface pass have in common.
struct SurfacePipelineDesc {
    std::string_view label;  ///< static
    std::string_view vertexShader;
    std::string_view fragmentShader;
    uint32_t usedFlags = ~0u;  ///< surface flags that change the program; others are masked off
    CompareOp depthTest = CompareOp::greater;
    bool depthWrite = true;
    bool depthClamp = false;
    float depthBias = 0;
    float depthBiasSlope = 0;
    BlendMode blend = BlendMode::off;
    BlendMode transmissive = BlendMode::off;  ///< of surfaces that light goes through
};

/// What surfaces read to lay decals over themselves; none where `records` is empty.
struct DecalBindings {
    BufferRange records;  ///< GpuDecal
    BufferRange lists;    ///< DecalClusters::lists
    TextureHandle color, detail;
    SamplerHandle sampler;

    explicit operator bool() const { return records.size > 0; }
    void bind(PassBuilder& pass) const;
};

/// What all passes that draw surfaces read of their materials.
void bindMaterials(PassBuilder& pass, const DrawBinder& binder);

/// The payload of a pass that draws one list.
struct DrawnList {
    const DrawList* list = nullptr;
    DrawBinder binder;
    static void record(const DrawnList& drawn, CommandBuffer& commands) {
        drawn.binder.record(commands, *drawn.list);
    }
};

/// The pipelines of a surface pass by variant, compiled when first needed.
class SurfacePipelines {
public:
    SurfacePipelines(Device& device, const SurfacePipelineDesc& desc)
        : device_(device), desc_(desc) {}

    /// Sets DrawBatch::pipeline. `extraDefines` are static texts; a different list makes different
    /// pipelines.
    Result<void> assign(DrawList& list, std::span<const std::string_view> extraDefines = {});

    /// Compiles what any object of the worlds may need, whether or not it is seen: a camera that
    /// turns compiles nothing. `flagsOf` maps an object's flags to those of its pipeline here; 0
    /// with kNoPipeline where it has none.
    static constexpr uint32_t kNoPipeline = ~0u;
    Result<void> prepare(const FrameWorlds& worlds, uint32_t (*flagsOf)(uint32_t flags),
                         std::span<const std::string_view> extraDefines = {});

private:
    struct Entry {
        uint32_t flags;
        std::vector<std::string_view> extraDefines;
        PipelineHandle pipeline;
    };
    Result<PipelineHandle> find(uint32_t flags, std::span<const std::string_view> extraDefines);

    Device& device_;
    SurfacePipelineDesc desc_;
    std::vector<Entry> entries_;
    uint64_t prepared_ = 0;  ///< hash of what prepare() last saw
};

}  // namespace rushlight

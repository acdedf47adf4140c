#pragma once
// The shadow maps of point and spot lights: all squares of the atlas that are not as they should
// be, in one pass. Each is a viewport and a scissor rectangle with draws of its own: casters are
// culled by view, so that views share few draws, and on llvmpipe, where one thread works on
// vertices, a viewport chosen in the vertex shader would have to look up its matrix for every
// vertex and save nothing.

#include "renderer/passes/surface/surface_pipelines.h"
#include "renderer/plan/image_history.h"
#include "renderer/shadows/shadow_schedule.h"

namespace rushlight {

/// The images that hold what ShadowAtlasHistory says. A value.
struct AtlasGenerations {
    static constexpr const char* kAtlas = "shadow-atlas";
    static constexpr const char* kStill = "shadow-atlas-still";
    static constexpr const char* kGlass = "shadow-atlas-glass";
    uint32_t atlas = 0, still = 0, glass = 0;  ///< 0: never drawn into
};

class ShadowAtlasPass {
public:
    struct Inputs {
        std::span<const ShadowDraw> draws;  ///< until the plan is recorded
        DrawBinder binder;
        uint32_t size = 0;  ///< texels a side
        const FrameWorlds* worlds = nullptr;
        ImageHistory* images = nullptr;       ///< the view's
        AtlasGenerations* history = nullptr;  ///< of the frame before; becomes this frame's
    };
    struct Outputs {
        ImageId atlas;  ///< D32F array of one layer; see ShadowView
    };

    explicit ShadowAtlasPass(Device& device);
    Result<Outputs> add(FramePlan& plan, const Inputs& inputs);

private:
    struct Payload {
        std::span<const ShadowDraw> draws;
        DrawBinder binder;
        PipelineHandle clear, copy;
    };
    static void recordLayer(const Payload&, CommandBuffer&);
    static void recordAtlas(const Payload&, CommandBuffer&);
    Result<void> createPipelines();

    Device& device_;
    SurfacePipelines pipelines_;
    SamplerHandle nearest_;
    PipelineHandle clear_, copy_;
};

}  // namespace rushlight

#pragma once
// The shadow maps of point and spot lights: all squares of the atlas that are not as they should
// be, in one pass. Each is a viewport and a scissor rectangle with draws of its own: casters are
// culled by view, so that views share few draws, and on llvmpipe, where one thread works on
// vertices, a viewport chosen in the vertex shader would have to look up its matrix for every
// vertex and save nothing.

#include "renderer/passes/surface/surface_pipelines.h"
#include "renderer/plan/frame_plan.h"
#include "renderer/shadows/shadow_schedule.h"

namespace rushlight {

class ShadowAtlasPass {
public:
    struct Inputs {
        std::span<const ShadowDraw> draws;  ///< until the plan is recorded
        DrawBinder binder;
        uint32_t size = 0;  ///< texels a side
    };
    struct Outputs {
        ImageId atlas;  ///< D32F array of one layer; see ShadowView
    };

    explicit ShadowAtlasPass(Device& device);
    ~ShadowAtlasPass();
    Result<Outputs> add(FramePlan& plan, const Inputs& inputs);
    /// What was planned may not have been drawn: the maps hold nothing.
    void forget() { atlasIsNew_ = layerIsNew_ = true; }

private:
    struct Payload {
        std::span<const ShadowDraw> draws;
        DrawBinder binder;
        PipelineHandle clear, copy;
        ImageId layer;
        SamplerHandle nearest;
    };
    static void recordLayer(const Payload&, PassContext&);
    static void recordAtlas(const Payload&, PassContext&);
    Result<void> prepare(uint32_t size, bool needsLayer);
    Result<TextureHandle> createMap(const char* label, uint32_t size);
    Result<void> createPipelines();

    Device& device_;
    SurfacePipelines pipelines_;
    SamplerHandle nearest_;
    PipelineHandle clear_, copy_;
    TextureHandle atlas_, layer_;
    bool atlasIsNew_ = false, layerIsNew_ = false;
    uint32_t size_ = 0;
};

}  // namespace rushlight

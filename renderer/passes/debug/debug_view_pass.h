#pragma once
// An intermediate image as the picture: G-buffer channels, depth, velocity, shadow cascades, light
// clusters. DebugView::untextured to bloom are radiance: those go through TonemapPass.

#include "renderer/frame/frame_input.h"
#include "renderer/passes/fullscreen.h"
#include "renderer/passes/surface/gbuffer_pass.h"
#include "renderer/plan/final_target.h"

namespace rushlight {

class DebugViewPass {
public:
    struct Inputs {
        DebugView view = DebugView::baseColor;
        GBufferPass::Outputs gbuffer;
        ImageId ambientOcclusion;  ///< null: shown as black
        ImageId overdraw;          ///< OverdrawPass::Outputs; null: shown as black
        ImageId shadowMap;         ///< null: no shadows, shown as black
        uint32_t shadowCascades = 0;
        ImageId shadowAtlas;                       ///< null: none; else beside the cascades
        BufferRange clusters;                      ///< LightingBindings::clusters; empty: no lights
        uint32_t clusterWords = 1;                 ///< LightClusters::recordWords
        vec4 clusterMapping{0}, clusterCounts{0};  ///< as LightingUniforms
        vec2 depthDecode{0, 1};                    ///< CameraMatrices::depthDecode
        bool orthographic = false;
        float nearestDepth = 0.1f, farthestDepth = 100;  ///< metres: white and black of
                                                         ///< DebugView::depth
        FinalTarget target;
        CommandBuffer* data = nullptr;
    };

    explicit DebugViewPass(Device& device);
    /// Whether `view` is one of this pass's.
    static bool shows(DebugView view);
    Result<void> add(FramePlan& plan, const Inputs& inputs);

private:
    FullscreenPipelines pipelines_;
    SamplerHandle nearest_;
};

}  // namespace rushlight

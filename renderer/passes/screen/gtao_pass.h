#pragma once
// Ambient occlusion of what the screen shows, with bent normals, at half the size: a search for
// horizons (gtao) and the mean of its pattern on each surface (gtao.denoise). Lighting brings it to
// full size as it reads it. Jimenez et al. 2016, "Practical Real-Time Strategies for Accurate
// Indirect Occlusion".
//
// A function of this frame's depth and normals alone: no history, the same bytes every time.

#include "renderer/frame/frame_settings.h"
#include "renderer/passes/fullscreen.h"
#include "renderer/passes/surface/gbuffer_pass.h"
#include "shaders/interop/screen_uniforms.h"

namespace rushlight {

class GtaoPass {
public:
    struct Inputs {
        GBufferPass::Outputs gbuffer;
        interop::ScreenUniforms screen;  ///< makeScreenUniforms; `settings` are the pass's
        AmbientOcclusion quality = AmbientOcclusion::medium;  ///< not off
        float radius = 1;                                     ///< metres
        bool orthographic = false;
        CommandBuffer* data = nullptr;   ///< gets the uniforms
        uint32_t width = 0, height = 0;  ///< of the frame
    };
    struct Outputs {
        ImageId occlusion;  ///< RGBA32F, halfSize() of the frame; drawn in
                            ///< shaders/interop/occlusion_arc.h
    };

    explicit GtaoPass(Device& device);
    Result<Outputs> add(FramePlan& plan, const Inputs& inputs);

private:
    FullscreenPipelines search_, denoise_;
    SamplerHandle nearest_;
};

}  // namespace rushlight

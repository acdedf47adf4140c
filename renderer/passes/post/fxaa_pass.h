#pragma once
// Anti-aliasing of the displayed picture. Lottes 2009, "FXAA".

#include "renderer/passes/fullscreen.h"
#include "renderer/plan/final_target.h"

namespace rushlight {

class FxaaPass {
public:
    struct Inputs {
        ImageId display;           ///< RGBA8 from TonemapPass, as large as the target
        bool lumaInAlpha = false;  ///< as TonemapPass wrote it; else alpha is kept and green is the
                                   ///< luma
        FinalTarget target;
        CommandBuffer* data = nullptr;
    };

    explicit FxaaPass(Device& device)
        : pipelines_(device, "fxaa", "passes/post/fxaa.frag"),
          linear_(linearClampSampler(device)) {}
    Result<void> add(FramePlan& plan, const Inputs& inputs);

private:
    FullscreenPipelines pipelines_;
    SamplerHandle linear_;
};

}  // namespace rushlight

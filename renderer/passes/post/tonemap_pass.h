#pragma once
// Linear radiance to 8-bit display colour: bloom, exposure, tone map, sRGB, dithering.
// shaders/interop/tonemap.h.

#include "renderer/frame/frame_input.h"
#include "renderer/passes/fullscreen.h"
#include "renderer/plan/final_target.h"

namespace rushlight {

class TonemapPass {
public:
    struct Inputs {
        ImageId radiance;
        ImageId bloom;     ///< null: none
        ImageId exposure;  ///< of ExposurePass; null: by the settings
        const FrameSettings* settings = nullptr;
        bool transparent = false;  ///< keep the radiance's alpha; the result has straight alpha
        bool lumaInAlpha = false;  ///< for FxaaPass; not with `transparent`
        FinalTarget target;        ///< an image of RGBA8, or the host's framebuffer
        CommandBuffer* data = nullptr;
    };

    explicit TonemapPass(Device& device);
    Result<void> add(FramePlan& plan, const Inputs& inputs);

private:
    FullscreenPipelines pipelines_;
    SamplerHandle linear_, nearest_;
};

/// The factor on radiance when exposure is not automatic. EV100 as Lagarde and de Rousiers 2014,
/// "Moving Frostbite to PBR": white is 1.2 * 2^EV100 cd/m².
float exposureFactor(const FrameSettings& settings);

}  // namespace rushlight

#pragma once
// From linear radiance to what is displayed.

#include "renderer/passes/post/bloom_pass.h"
#include "renderer/passes/post/exposure_pass.h"
#include "renderer/passes/post/fxaa_pass.h"
#include "renderer/passes/post/tonemap_pass.h"
#include "renderer/pipeline/frame_context.h"

namespace rushlight {

class PostStage {
public:
    /// Light that the lens scatters, and the exposure, as far as the frame has them.
    struct Scattered {
        ImageId bloom;     ///< null: none; published as "bloom"
        ImageId exposure;  ///< null: by the settings
    };
    struct DisplayInputs {
        ImageId radiance;
        Scattered scattered;
        const FrameSettings* settings = nullptr;
        FinalTarget target;
    };

    explicit PostStage(Device& device)
        : bloomPass_(device), exposurePass_(device), tonemapPass_(device), fxaaPass_(device) {}
    Result<Scattered> scatter(FrameContext& frame, const FrameSettings& settings, ImageId radiance);
    Result<void> display(FrameContext& frame, const DisplayInputs& inputs);

private:
    BloomPass bloomPass_;
    ExposurePass exposurePass_;
    TonemapPass tonemapPass_;
    FxaaPass fxaaPass_;
};

}  // namespace rushlight

#pragma once
// Automatic exposure: the factor that brings the picture's mean log luminance to middle grey,
// adapting with time. It stays on the GPU, in one texel.

#include "renderer/passes/fullscreen.h"
#include "renderer/plan/image_history.h"

namespace rushlight {

/// The exposure as a view remembers it. A value.
struct ExposureHistory {
    bool started = false;
    uint32_t current = 0;  ///< which of the two texels holds it
};

class ExposurePass {
public:
    struct Inputs {
        ImageId source;  ///< BloomPass::Outputs::smallest
        uint32_t sourceWidth = 0, sourceHeight = 0;
        CommandBuffer* data = nullptr;
        float deltaTime = 0;  ///< seconds; the first frame takes its own exposure at once
        ImageHistory* images = nullptr;      ///< the view's
        ExposureHistory* history = nullptr;  ///< of the frame before; becomes this frame's
    };
    struct Outputs {
        ImageId exposure;  ///< R32F, 1x1: a factor on radiance
    };

    explicit ExposurePass(Device& device);
    Result<Outputs> add(FramePlan& plan, const Inputs& inputs);

private:
    Result<ImageId> import(FramePlan& plan, ImageHistory& images, uint32_t texel, const char* name);

    Device& device_;
    FullscreenPipelines luminance_, exposure_;
    SamplerHandle linear_, nearest_;
};

}  // namespace rushlight

#pragma once
// Automatic exposure: the factor that brings the picture's mean log luminance to middle grey,
// adapting with time. It stays on the GPU, in one texel.

#include "renderer/passes/fullscreen.h"

#include <array>

namespace rushlight {

class ExposurePass {
public:
    struct Inputs {
        ImageId source;  ///< BloomPass::Outputs::smallest
        uint32_t sourceWidth = 0, sourceHeight = 0;
        CommandBuffer* data = nullptr;
        float deltaTime = 0;  ///< seconds; the first frame takes its own exposure at once
    };
    struct Outputs {
        ImageId exposure;  ///< R32F, 1x1: a factor on radiance
    };

    explicit ExposurePass(Device& device);
    ~ExposurePass();
    ExposurePass(const ExposurePass&) = delete;
    ExposurePass& operator=(const ExposurePass&) = delete;

    Result<Outputs> add(FramePlan& plan, const Inputs& inputs);

    /// The next frame does not adapt from what was before.
    void reset() { started_ = false; }

private:
    Result<void> reserve();

    Device& device_;
    FullscreenPipelines luminance_, exposure_;
    SamplerHandle linear_, nearest_;
    std::array<TextureHandle, 2> texels_;  ///< last frame's and this one's, in turn
    uint32_t current_ = 0;
    bool started_ = false;
};

}  // namespace rushlight

#pragma once
// Light that the eye or lens scatters: a pyramid of blurred copies, from half the size down, mixed
// back up. Bjorge 2015, "Bandwidth-Efficient Rendering". The sum of all weights is one: bloom
// spreads light and adds none.

#include "renderer/passes/fullscreen.h"

namespace rushlight {

class BloomPass {
public:
    struct Inputs {
        ImageId radiance;
        CommandBuffer* data = nullptr;  ///< gets the uniforms
        uint32_t width = 0, height = 0;
    };
    struct Outputs {
        ImageId bloom;     ///< R11G11B10F, half the size; to be mixed in by
                           ///< FrameSettings::bloomStrength
        ImageId smallest;  ///< the coarsest level, at most 1/64 of the size: for exposure
        uint32_t smallestWidth = 0, smallestHeight = 0;
    };

    explicit BloomPass(Device& device);
    Result<Outputs> add(FramePlan& plan, const Inputs& inputs);

private:
    FullscreenPipelines down_, up_;
    SamplerHandle linear_;
};

}  // namespace rushlight

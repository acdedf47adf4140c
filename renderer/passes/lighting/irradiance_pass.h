#pragma once
// Light around the visible surfaces, from an irradiance volume, at half the size of the picture:
// lighting reads it at each pixel's own normal. Shaders: passes/lighting/irradiance.frag,
// common/light/irradiance_probes.glsl, common/light/local_light.glsl.

#include "renderer/passes/lighting/lighting_pass.h"

namespace rushlight {

class IrradiancePass {
public:
    struct Inputs {
        GBufferPass::Outputs gbuffer;
        LightingBindings lighting;  ///< with an irradiance volume
        uint32_t width = 0, height = 0;
    };
    struct Outputs {
        ImageId tint;  ///< RGBA16F; a: metres from the eye
        ImageId flow;  ///< RGBA8
    };

    explicit IrradiancePass(Device& device);
    Result<Outputs> add(FramePlan& plan, const Inputs& inputs);

private:
    Device& device_;
    SamplerHandle nearest_;
    PipelineHandle pipelines_[2];  ///< perspective, orthographic
};

}  // namespace rushlight

#pragma once
// Reflections of what the screen shows, found at half the size (reflections.trace) and put in the
// place of the mirrored environment where something was hit (reflections). A function of this frame
// alone. Mirrors rougher than 0.6 keep the environment; so does what looks out of the picture,
// behind things or at their backs.

#include "renderer/passes/lighting/lighting_pass.h"
#include "renderer/passes/screen/pyramid_pass.h"

namespace rushlight {

class ReflectionsPass {
public:
    struct Inputs {
        GBufferPass::Outputs gbuffer;
        LightingBindings lighting;     ///< those that lit `radiance`
        ImageId ambientOcclusion;      ///< the one that lit `radiance`; null: none
        ImageId localTint, localFlow;  ///< likewise, of IrradiancePass
        PyramidPass::Outputs pyramid;
        interop::ScreenUniforms screen;
        ImageId radiance;    ///< reflections are added to it
        bool alone = false;  ///< the reflections go into an image of their own instead
        CommandBuffer* data = nullptr;
        uint32_t width = 0, height = 0;
    };
    struct Outputs {
        ImageId radiance;  ///< Inputs::radiance, or the reflections alone
    };

    explicit ReflectionsPass(Device& device);
    Result<Outputs> add(FramePlan& plan, const Inputs& inputs);

private:
    struct Composite {
        uint32_t features = 0;
        PipelineHandle pipeline;
    };
    Result<PipelineHandle> findComposite(const Inputs& inputs);
    ImageId addTrace(FramePlan& plan, const Inputs& inputs, PipelineHandle pipeline);

    Device& device_;
    FullscreenPipelines trace_;
    std::vector<Composite> composites_;
    SamplerHandle nearest_, linear_;
};

}  // namespace rushlight

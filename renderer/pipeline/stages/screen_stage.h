#pragma once
// What is found in the image of the scene itself, and what is laid over it: reflections, fog.

#include "renderer/passes/screen/fog_pass.h"
#include "renderer/passes/screen/pyramid_pass.h"
#include "renderer/passes/screen/reflections_pass.h"
#include "renderer/pipeline/stages/lighting_stage.h"

namespace rushlight {

class ScreenStage {
public:
    struct Inputs {
        const GBufferPass::Outputs* gbuffer = nullptr;
        const LightingStage::Outputs* lit = nullptr;
    };
    struct Outputs {
        ImageId radiance;
        ImageId fog;  ///< FogPass::Outputs; null without fog
    };

    explicit ScreenStage(Device& device)
        : pyramidPass_(device), reflectionsPass_(device), fogPass_(device) {}
    Result<Outputs> add(FrameContext& frame, const Inputs& inputs);

private:
    /// The radiance with reflections in it, as far as they are wanted.
    Result<ImageId> addReflections(FrameContext& frame, const Inputs& inputs);
    /// Fog over the radiance; a null image without.
    Result<ImageId> addFog(FrameContext& frame, const Inputs& inputs, ImageId radiance);

    PyramidPass pyramidPass_;
    ReflectionsPass reflectionsPass_;
    FogPass fogPass_;
};

}  // namespace rushlight

#pragma once
// The G-buffer under the lights of the frame: froxels, ambient occlusion, local ambient light, and
// the deferred lighting.

#include "renderer/lighting/clusters/light_clusters.h"
#include "renderer/lighting/fog.h"
#include "renderer/passes/lighting/irradiance_pass.h"
#include "renderer/passes/lighting/lighting_pass.h"
#include "renderer/passes/screen/gtao_pass.h"
#include "renderer/pipeline/stages/shadow_stage.h"
#include "renderer/pipeline/stages/surface_stage.h"

namespace rushlight {

class LightingStage {
public:
    struct Inputs {
        const SurfaceStage::Outputs* surface = nullptr;
        const ShadowStage::Views* views = nullptr;
        const ShadowStage::Outputs* shadows = nullptr;
    };
    struct Outputs {
        LightingBindings lighting;     ///< for all that is lit afterwards
        ImageId ambientOcclusion;      ///< null: the ambient light is open
        ImageId localTint, localFlow;  ///< of IrradiancePass; null without an irradiance volume
        FogGrid fog;
        const LightClusters* clusters = nullptr;  ///< until the next frame
        ImageId radiance;                         ///< published as "lighting"
    };

    explicit LightingStage(Device& device);
    Result<Outputs> add(FrameContext& frame, const Inputs& inputs);

private:
    Result<LightingBindings> bind(FrameContext& frame, const Inputs& inputs, FogGrid& fog);
    LightingFeatures featuresOf(FrameContext& frame, const Inputs& inputs) const;
    void bindLights(FrameContext& frame, LightingBindings& bindings) const;
    Result<void> bindSurroundings(FrameContext& frame, LightingBindings& bindings) const;
    Result<ImageId> addAmbientOcclusion(FrameContext& frame, const GBufferPass::Outputs& gbuffer,
                                        const LightingFeatures& features);
    Result<void> addParts(FrameContext& frame, LightingPass::Inputs inputs);

    GtaoPass gtaoPass_;
    IrradiancePass irradiancePass_;
    LightingPass lightingPass_;
    SamplerHandle shadowSampler_, cubeSampler_, linearSampler_;
    LightClusters clusters_;  ///< worked out anew each frame
};

}  // namespace rushlight

#pragma once
// Volumetric fog: light scattered in froxels, summed from the eye, and laid over the radiance.

#include "renderer/lighting/fog.h"
#include "renderer/passes/fullscreen.h"
#include "renderer/passes/lighting/lighting_pass.h"

namespace rushlight {

class FogPass {
public:
    struct Inputs {
        LightingBindings lighting;
        FogGrid grid;
    };
    struct Outputs {
        ImageId fog;  ///< RGBA16F, as FogGrid says: what is added up to each slice's end, and the
                      ///< share covered
    };
    struct Target {
        ImageId fog;
        ImageId radiance;  ///< covered with fog
        ImageId depth;
        BufferRange uniforms;  ///< interop::LightingUniforms
        bool clear = false;    ///< the radiance was nothing before
        bool orthographic = false;
    };

    explicit FogPass(Device& device);
    /// Gathers the light.
    Result<Outputs> add(FramePlan& plan, const Inputs& inputs);
    Result<void> apply(FramePlan& plan, const Target& target);

private:
    struct Scatter {
        LightingFeatures features;
        PipelineHandle pipeline;
    };
    Result<PipelineHandle> findScatter(const LightingFeatures&);
    Result<PipelineHandle> findSum(const char* label, const char* shader, PipelineHandle& kept);
    Result<PipelineHandle> findApply(bool orthographic);

    Device& device_;
    std::vector<Scatter> scatters_;
    PipelineHandle blocks_, join_;
    std::array<PipelineHandle, 2> apply_;  ///< perspective, orthographic
    SamplerHandle nearest_, linear_;
};

}  // namespace rushlight

#pragma once
// What the G-buffer cannot hold, over the lit scene: blended surfaces from back to front, and the
// emission of surfaces whose G-buffer texel holds velocity instead. Same lights, same BRDF
// (shaders/common/light/lighting.glsl).

#include "renderer/passes/lighting/lighting_pass.h"
#include "renderer/passes/surface/surface_pipelines.h"
#include "renderer/plan/frame_plan.h"

namespace rushlight {

class ForwardPass {
public:
    struct Inputs {
        DrawList* blended = nullptr;
        DrawList* movingEmissive = nullptr;
        DrawBinder binder;
        BufferRange viewUniforms;
        LightingBindings lighting;
        ImageId radiance;
        ImageId depth;
        DecalBindings decals;
        ImageId fog;                          ///< FogPass::Outputs; null without fog
        const FrameWorlds* worlds = nullptr;  ///< whose objects may be drawn
    };
    struct Outputs {
        ImageId radiance;
    };

    explicit ForwardPass(Device& device);
    Result<Outputs> add(FramePlan& plan, const Inputs& inputs);

private:
    Result<void> prepare(const FrameWorlds& worlds, std::span<const std::string_view> emission);

    SurfacePipelines blend_;
    SurfacePipelines emission_;
    std::vector<std::string_view> defines_;
};

}  // namespace rushlight

#include "renderer/passes/lighting/irradiance_pass.h"

#include "renderer/passes/fullscreen.h"
#include "shaders/interop/bindings.h"

namespace rushlight {
IrradiancePass::IrradiancePass(Device& device)
    : device_(device), nearest_(nearestClampSampler(device)) {}

Result<IrradiancePass::Outputs> IrradiancePass::add(FramePlan& plan, const Inputs& inputs) {
    const bool orthographic = inputs.lighting.features.orthographic;
    PipelineHandle& pipeline = pipelines_[orthographic];
    if (!pipeline) {
        constexpr std::string_view kDefines[] = {"DIRECTIONAL_LIGHTS 0", "IRRADIANCE_LOOKUP",
                                                 "ORTHOGRAPHIC"};
        PipelineDesc desc;
        desc.label = "irradiance";
        desc.vertexShader = "passes/lighting/irradiance.vert";
        desc.fragmentShader = "passes/lighting/irradiance.frag";
        desc.defines = {kDefines, orthographic ? size_t(3) : size_t(2)};
        auto made = device_.createPipeline(desc);
        if (!made) return tl::unexpected(made.error());
        pipeline = *made;
    }
    const uint32_t w = (inputs.width + 1) / 2, h = (inputs.height + 1) / 2;
    Outputs out;
    out.tint = plan.createImage({"local-light-tint", Format::rgba16f, w, h});
    out.flow = plan.createImage({"local-light-flow", Format::rgba8, w, h});
    PassBuilder pass = plan.addPass("irradiance");
    pass.color(out.tint).color(out.flow);
    pass.uniforms(RL_UNIFORMS_LIGHTING, inputs.lighting.uniforms);
    inputs.lighting.bindProbes(pass);
    pass.sample(RL_TEXTURE_GBUFFER1, inputs.gbuffer.target1, nearest_);
    pass.sample(RL_TEXTURE_DEPTH, inputs.gbuffer.depth, nearest_);
    pass.fullscreen(pipeline);
    return out;
}

}  // namespace rushlight

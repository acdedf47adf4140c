#include "renderer/passes/lighting/irradiance_pass.h"

#include "renderer/passes/fullscreen.h"
#include "shaders/interop/bindings.h"

namespace rushlight {
namespace {

struct Payload {
    ImageId normals, depth;
    LightingBindings lighting;
    PipelineHandle pipeline;
    SamplerHandle nearest;
};

void record(const Payload& p, PassContext& context) {
    CommandBuffer& commands = context.commands;
    commands.push(BindUniforms{RL_UNIFORMS_LIGHTING, 0, p.lighting.uniforms});
    p.lighting.recordProbes(context);
    commands.push(BindTexture{RL_TEXTURE_GBUFFER1, context.texture(p.normals), p.nearest});
    commands.push(BindTexture{RL_TEXTURE_DEPTH, context.texture(p.depth), p.nearest});
    commands.push(SetPipeline{p.pipeline});
    commands.push(Draw{3, 1, 0});
}

}  // namespace

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
    const PassTargets::Color colors[] = {{out.tint}, {out.flow}};
    const ImageId reads[] = {inputs.gbuffer.target1, inputs.gbuffer.depth};
    PassTargets targets;
    targets.colors = colors;
    targets.reads = reads;
    plan.addPass<Payload>(
        "irradiance", targets,
        {inputs.gbuffer.target1, inputs.gbuffer.depth, inputs.lighting, pipeline, nearest_},
        record);
    return out;
}

}  // namespace rushlight

#include "renderer/passes/screen/fog_pass.h"

#include "shaders/interop/bindings.h"

namespace rushlight {
FogPass::FogPass(Device& device)
    : device_(device), nearest_(nearestClampSampler(device)), linear_(linearClampSampler(device)) {}

Result<PipelineHandle> FogPass::findScatter(const LightingFeatures& features) {
    for (const Scatter& s : scatters_)
        if (s.features == features) return s.pipeline;
    std::vector<std::string_view> defines{"FOG_SAMPLES 2"};
    features.appendDefines(defines);
    PipelineDesc desc;
    desc.label = "fog-scatter";
    desc.vertexShader = "passes/screen/fog.vert";
    desc.fragmentShader = "passes/screen/fog_scatter.frag";
    desc.defines = defines;
    auto pipeline = device_.createPipeline(desc);
    if (pipeline) scatters_.push_back({features, *pipeline});
    return pipeline;
}

Result<PipelineHandle> FogPass::findSum(const char* label, const char* shader,
                                        PipelineHandle& kept) {
    if (kept) return kept;
    PipelineDesc desc;
    desc.label = label;
    desc.vertexShader = "passes/screen/fog.vert";
    desc.fragmentShader = shader;
    auto pipeline = device_.createPipeline(desc);
    if (pipeline) kept = *pipeline;
    return pipeline;
}

Result<PipelineHandle> FogPass::findApply(bool orthographic) {
    PipelineHandle& kept = apply_[orthographic];
    if (kept) return kept;
    constexpr std::string_view kOrthographic[] = {"ORTHOGRAPHIC"};
    PipelineDesc desc;
    desc.label = "fog";
    desc.vertexShader = "passes/screen/fog.vert";
    desc.fragmentShader = "passes/screen/fog_apply.frag";
    if (orthographic) desc.defines = kOrthographic;
    desc.blend = BlendMode::premultiplied;
    auto pipeline = device_.createPipeline(desc);
    if (pipeline) kept = *pipeline;
    return pipeline;
}

Result<FogPass::Outputs> FogPass::add(FramePlan& plan, const Inputs& inputs) {
    const auto scatter = findScatter(inputs.lighting.features);
    const auto blocks = findSum("fog-blocks", "passes/screen/fog_blocks.frag", blocks_);
    const auto join = findSum("fog-join", "passes/screen/fog_join.frag", join_);
    for (const auto* pipeline : {&scatter, &blocks, &join})
        if (!*pipeline) return tl::unexpected(pipeline->error());

    const auto image = [&](const char* name) {
        return plan.createImage(
            {name, Format::rgba16f, inputs.grid.imageWidth(), inputs.grid.imageHeight()});
    };
    const ImageId slices = image("fog-slices"), rows = image("fog-blocks");
    Outputs out{image("fog")};
    {
        PassBuilder pass = plan.addPass("fog.scatter");
        pass.color(slices);
        inputs.lighting.bind(pass);
        if (inputs.lighting.features.irradianceVolume) inputs.lighting.bindProbes(pass);
        pass.fullscreen(*scatter);
    }
    const auto sum = [&](const char* name, ImageId from, ImageId to, PipelineHandle pipeline) {
        PassBuilder pass = plan.addPass(name);
        pass.color(to);
        pass.uniforms(RL_UNIFORMS_LIGHTING, inputs.lighting.uniforms);
        pass.sample(RL_TEXTURE_SOURCE0, from, nearest_);
        pass.fullscreen(pipeline);
    };
    sum("fog.blocks", slices, rows, *blocks);
    sum("fog.join", rows, out.fog, *join);
    return out;
}

Result<void> FogPass::apply(FramePlan& plan, const Target& target) {
    const auto pipeline = findApply(target.orthographic);
    if (!pipeline) return tl::unexpected(pipeline.error());
    PassBuilder pass = plan.addPass("fog");
    pass.color(target.radiance, target.clear ? LoadOp::clear : LoadOp::keep);
    pass.uniforms(RL_UNIFORMS_LIGHTING, target.uniforms);
    pass.sample(RL_TEXTURE_FOG, target.fog, linear_);
    pass.sample(RL_TEXTURE_DEPTH, target.depth, nearest_);
    pass.fullscreen(*pipeline);
    return {};
}

}  // namespace rushlight

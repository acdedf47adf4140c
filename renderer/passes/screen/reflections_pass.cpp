#include "renderer/passes/screen/reflections_pass.h"

#include "renderer/passes/screen/screen_uniforms.h"
#include "shaders/interop/bindings.h"

namespace rushlight {
namespace {

/// No light but the ambient one is needed.
LightingFeatures ambientOnly(const LightingFeatures& lit) {
    LightingFeatures f;
    f.environment = lit.environment;
    f.hemisphere = lit.hemisphere;
    f.orthographic = lit.orthographic;
    f.irradianceVolume = lit.irradianceVolume;
    f.reflectionProbes = lit.reflectionProbes;
    return f;
}

}  // namespace

ReflectionsPass::ReflectionsPass(Device& device)
    : device_(device),
      trace_(device, "reflections-trace", "passes/screen/reflections_trace.frag", BlendMode::off,
             "passes/screen/screen_space.vert"),
      nearest_(nearestClampSampler(device)),
      linear_(linearClampSampler(device)) {}

Result<PipelineHandle> ReflectionsPass::findComposite(const Inputs& inputs) {
    const LightingFeatures& lit = inputs.lighting.features;
    const uint32_t features = uint32_t(lit.environment) | uint32_t(lit.hemisphere) << 1 |
                              uint32_t(lit.orthographic) << 2 |
                              uint32_t(bool(inputs.ambientOcclusion)) << 3 |
                              uint32_t(inputs.alone) << 4 | uint32_t(lit.irradianceVolume) << 5 |
                              uint32_t(lit.reflectionProbes) << 6;
    for (const Composite& known : composites_)
        if (known.features == features) return known.pipeline;
    std::vector<std::string_view> defines;
    ambientOnly(lit).appendDefines(defines);
    if (inputs.ambientOcclusion) defines.push_back("AMBIENT_OCCLUSION");
    if (inputs.alone) defines.push_back("SHOW_REFLECTIONS");
    PipelineDesc desc;
    desc.label = "reflections";
    desc.vertexShader = "passes/lighting/lighting.vert";
    desc.fragmentShader = "passes/screen/reflections_composite.frag";
    desc.defines = defines;
    desc.depthTest = CompareOp::less;
    desc.blend = BlendMode::additive;
    const auto pipeline = device_.createPipeline(desc);
    if (pipeline) composites_.push_back({features, *pipeline});
    return pipeline;
}

ImageId ReflectionsPass::addTrace(FramePlan& plan, const Inputs& inputs, PipelineHandle pipeline) {
    const GBufferPass::Outputs& g = inputs.gbuffer;
    const ImageId traced = plan.createImage(
        {"reflections", Format::rgba32f, halfSize(inputs.width), halfSize(inputs.height)});
    const BufferRange uniforms = inputs.data->append(
        std::span<const interop::ScreenUniforms>(&inputs.screen, 1));
    PassBuilder pass = plan.addPass("reflections.trace");
    pass.color(traced);
    pass.uniforms(RL_UNIFORMS_PASS, uniforms);
    pass.sample(RL_TEXTURE_GBUFFER1, g.target1, nearest_);
    pass.sample(RL_TEXTURE_DEPTH, g.depth, nearest_);
    pass.sample(RL_TEXTURE_SOURCE0, inputs.pyramid.radiance, linear_);
    pass.sample(RL_TEXTURE_SOURCE1, inputs.pyramid.nearest, nearest_);
    pass.fullscreen(pipeline);
    return traced;
}

Result<ReflectionsPass::Outputs> ReflectionsPass::add(FramePlan& plan, const Inputs& inputs) {
    constexpr std::string_view kOrthographic[] = {"ORTHOGRAPHIC"};
    const auto trace = trace_.find(
        {kOrthographic, inputs.lighting.features.orthographic ? size_t(1) : size_t(0)});
    if (!trace) return tl::unexpected(trace.error());
    const auto composite = findComposite(inputs);
    if (!composite) return tl::unexpected(composite.error());
    const ImageId traced = addTrace(plan, inputs, *trace);

    const GBufferPass::Outputs& g = inputs.gbuffer;
    Outputs out{inputs.radiance};
    if (inputs.alone)
        out.radiance = plan.createImage(
            {"reflections-alone", Format::rgba16f, inputs.width, inputs.height});
    LightingBindings lighting = inputs.lighting;
    lighting.features = ambientOnly(inputs.lighting.features);
    PassBuilder pass = plan.addPass("reflections");
    pass.color(out.radiance, inputs.alone ? LoadOp::clear : LoadOp::keep, vec4(0, 0, 0, 1));
    pass.depthTest(g.depth);
    LitScreenBindings{
        g, lighting, inputs.ambientOcclusion, inputs.localTint, inputs.localFlow, nearest_}
        .bind(pass);
    pass.sample(RL_TEXTURE_SOURCE0, traced, nearest_);
    pass.fullscreen(*composite);
    return out;
}

}  // namespace rushlight

#include "renderer/passes/screen/reflections_pass.h"

#include "renderer/passes/screen/screen_uniforms.h"
#include "shaders/interop/bindings.h"

namespace rushlight {
namespace {

struct Payload {
    LitScreenBindings screen;
    ImageId reflections;
    PipelineHandle pipeline;
};

void record(const Payload& p, PassContext& context) {
    CommandBuffer& commands = context.commands;
    p.screen.record(context);
    commands.push(
        BindTexture{RL_TEXTURE_SOURCE0, context.texture(p.reflections), p.screen.nearest});
    commands.push(SetPipeline{p.pipeline});
    commands.push(Draw{3, 1, 0});
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
    LightingFeatures ambient;  // of lighting's, what the mirrored environment needs
    ambient.environment = lit.environment;
    ambient.hemisphere = lit.hemisphere;
    ambient.orthographic = lit.orthographic;
    ambient.irradianceVolume = lit.irradianceVolume;
    ambient.reflectionProbes = lit.reflectionProbes;
    std::vector<std::string_view> defines;
    ambient.appendDefines(defines);
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
    FullscreenDraw draw{pipeline, uniforms, {}};
    draw.textures[0] = {RL_TEXTURE_GBUFFER1, g.target1, nearest_};
    draw.textures[1] = {RL_TEXTURE_DEPTH, g.depth, nearest_};
    draw.textures[2] = {RL_TEXTURE_SOURCE0, inputs.pyramid.radiance, linear_};
    draw.textures[3] = {RL_TEXTURE_SOURCE1, inputs.pyramid.nearest, nearest_};
    const PassTargets::Color colors[] = {{traced}};
    const ImageId reads[] = {g.target1, g.depth, inputs.pyramid.radiance, inputs.pyramid.nearest};
    PassTargets targets;
    targets.colors = colors;
    targets.reads = reads;
    plan.addPass<FullscreenDraw>("reflections.trace", targets, draw, FullscreenDraw::record);
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
    LightingBindings lighting = inputs.lighting;  // no light but the ambient one is needed
    lighting.features.shadowCascades = 0;
    lighting.features.plainLights = lighting.features.modulatedLights = false;
    lighting.features.areaLights = false;
    lighting.features.punctualShadow = lighting.features.areaShadow = false;
    lighting.features.secondSuns = 0;
    lighting.features.sunGlass = lighting.features.atlasGlass = false;
    const PassTargets::Color colors[] = {
        {out.radiance, inputs.alone ? LoadOp::clear : LoadOp::keep, vec4(0, 0, 0, 1)}};
    const ImageId reads[] = {g.target0,        g.target1,       g.target2,
                             g.depth,          traced,          inputs.ambientOcclusion,
                             inputs.localTint, inputs.localFlow};
    PassTargets targets;
    targets.colors = colors;
    targets.depth = {g.depth, LoadOp::keep, 0, true};
    targets.reads = reads;
    plan.addPass<Payload>(
        "reflections", targets,
        {{g, lighting, inputs.ambientOcclusion, inputs.localTint, inputs.localFlow, nearest_},
         traced,
         *composite},
        record);
    return out;
}

}  // namespace rushlight

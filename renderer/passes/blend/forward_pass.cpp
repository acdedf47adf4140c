#include "renderer/passes/blend/forward_pass.h"

#include "renderer/materials/surface_variant.h"
#include "shaders/interop/bindings.h"

namespace rushlight {
namespace {

struct Payload {
    const DrawList* lists[2];
    DrawBinder binder;
};

void record(const Payload& payload, CommandBuffer& commands) {
    for (const DrawList* list : payload.lists) payload.binder.record(commands, *list);
}

}  // namespace

ForwardPass::ForwardPass(Device& device)
    : blend_(device, {.label = "forward",
                      .vertexShader = "passes/surface/surface.vert",
                      .fragmentShader = "passes/blend/forward.frag",
                      .usedFlags = ~uint32_t(kMoving),
                      .depthTest = CompareOp::greaterOrEqual,
                      .depthWrite = false,
                      .blend = BlendMode::premultiplied,
                      .transmissive = BlendMode::filtered}),
      emission_(device, {.label = "emission",
                         .vertexShader = "passes/surface/surface.vert",
                         .fragmentShader = "passes/blend/forward.frag",
                         .depthTest = CompareOp::equal,
                         .depthWrite = false,
                         .blend = BlendMode::additive}) {}

Result<void> ForwardPass::prepare(const FrameWorlds& worlds,
                                  std::span<const std::string_view> emission) {
    const auto blended = [](uint32_t flags) {
        return flags & kBlend ? flags : SurfacePipelines::kNoPipeline;
    };
    const auto movingEmissive = [](uint32_t flags) {
        constexpr uint32_t kBoth = kMoving | kEmissive;
        return (flags & (kBoth | kBlend)) == kBoth ? flags : SurfacePipelines::kNoPipeline;
    };
    if (auto ok = blend_.prepare(worlds, blended, defines_); !ok) return ok;
    return emission_.prepare(worlds, movingEmissive, emission);
}

Result<ForwardPass::Outputs> ForwardPass::add(FramePlan& plan, const Inputs& inputs) {
    Outputs out{inputs.radiance};
    defines_.clear();
    defines_.push_back("FORWARD");
    inputs.lighting.features.appendDefines(defines_);
    if (inputs.decals) defines_.push_back("DECALS");
    if (inputs.fog) defines_.push_back("FOG");
    constexpr std::string_view kEmission[] = {"FORWARD", "EMISSION_ONLY", "DIRECTIONAL_LIGHTS 0",
                                              "FOG"};
    const auto emission = std::span(kEmission).first(inputs.fog ? 4 : 3);
    if (auto ok = prepare(*inputs.worlds, emission); !ok) return tl::unexpected(ok.error());
    if (inputs.blended->batches.empty() && inputs.movingEmissive->batches.empty()) return out;
    if (auto ok = blend_.assign(*inputs.blended, defines_); !ok) return tl::unexpected(ok.error());
    if (auto ok = emission_.assign(*inputs.movingEmissive, emission); !ok)
        return tl::unexpected(ok.error());
    PassBuilder pass = plan.addPass("forward");
    pass.color(inputs.radiance, LoadOp::keep);
    pass.depthTest(inputs.depth);
    pass.uniforms(RL_UNIFORMS_VIEW, inputs.viewUniforms);
    bindMaterials(pass, inputs.binder);
    inputs.lighting.bind(pass);
    if (inputs.lighting.features.irradianceVolume) inputs.lighting.bindProbes(pass);
    inputs.decals.bind(pass);
    pass.sample(RL_TEXTURE_FOG, inputs.fog, inputs.lighting.linearSampler);
    pass.record<Payload>({{inputs.movingEmissive, inputs.blended}, inputs.binder}, record);
    return out;
}

}  // namespace rushlight

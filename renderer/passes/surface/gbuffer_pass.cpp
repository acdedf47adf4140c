#include "renderer/passes/surface/gbuffer_pass.h"

#include "renderer/materials/surface_variant.h"
#include "shaders/interop/bindings.h"

namespace rushlight {

GBufferPass::GBufferPass(Device& device)
    : pipelines_(device, {.label = "gbuffer",
                          .vertexShader = "passes/surface/surface.vert",
                          .fragmentShader = "passes/surface/gbuffer.frag"}) {}

Result<GBufferPass::Outputs> GBufferPass::add(FramePlan& plan, const Inputs& inputs) {
    constexpr std::string_view kDecals[] = {"DECALS"};
    const std::span<const std::string_view> defines(kDecals, inputs.decals ? 1 : 0);
    const auto opaque = [](uint32_t flags) {
        return flags & kBlend ? SurfacePipelines::kNoPipeline : flags;
    };
    if (auto ok = pipelines_.prepare(*inputs.worlds, opaque, defines); !ok)
        return tl::unexpected(ok.error());
    if (auto ok = pipelines_.assign(*inputs.draws, defines); !ok) return tl::unexpected(ok.error());
    const uint32_t w = inputs.width, h = inputs.height;
    Outputs out;
    out.target0 = plan.createImage({"base-color-metallic", Format::rgba8, w, h});
    out.target1 = plan.createImage({"normal-roughness", Format::rgba8, w, h});
    out.target2 = plan.createImage({"emissive-velocity-occlusion", Format::rgba8, w, h});
    out.depth = plan.createImage({"depth", Format::depth32f, w, h});
    const PassTargets::Color colors[] = {
        {out.target0, LoadOp::clear}, {out.target1, LoadOp::clear}, {out.target2, LoadOp::clear}};
    PassTargets targets;
    targets.colors = colors;
    targets.depth = {out.depth, LoadOp::clear};
    plan.addPass<Inputs>("gbuffer", targets, inputs, [](const Inputs& in, PassContext& context) {
        context.commands.push(BindUniforms{RL_UNIFORMS_VIEW, 0, in.viewUniforms});
        context.commands.push(BindTexelBuffer{
            RL_TEXTURE_MATERIALS, Format::rgba32ui, {}, in.binder.materials->buffer()});
        in.decals.record(context.commands);
        in.binder.record(context.commands, *in.draws);
    });
    return out;
}

}  // namespace rushlight

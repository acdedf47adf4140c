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
    PassBuilder pass = plan.addPass("gbuffer");
    for (ImageId target : {out.target0, out.target1, out.target2})
        pass.color(target, LoadOp::clear);
    pass.depth(out.depth, LoadOp::clear);
    pass.uniforms(RL_UNIFORMS_VIEW, inputs.viewUniforms);
    inputs.decals.bind(pass);
    bindMaterials(pass, inputs.binder);
    pass.record<DrawnList>({inputs.draws, inputs.binder}, DrawnList::record);
    return out;
}

}  // namespace rushlight

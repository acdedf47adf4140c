#include "renderer/passes/debug/overdraw_pass.h"

#include "renderer/materials/surface_variant.h"
#include "shaders/interop/bindings.h"

namespace rushlight {

OverdrawPass::OverdrawPass(Device& device)
    : pipelines_(device, {.label = "overdraw",
                          .vertexShader = "passes/surface/surface.vert",
                          .fragmentShader = "passes/debug/overdraw.frag",
                          .usedFlags = kBaseColorTexture | kSecondUv | kUvTransforms | kAlphaMask |
                                       kDoubleSided | kMirrored | kExtended | kMoving,
                          .blend = BlendMode::additive}) {}

Result<OverdrawPass::Outputs> OverdrawPass::add(FramePlan& plan, const Inputs& inputs) {
    if (auto ok = pipelines_.assign(*inputs.draws); !ok) return tl::unexpected(ok.error());
    const uint32_t w = inputs.width, h = inputs.height;
    const Outputs out{plan.createImage({"overdraw", Format::r16f, w, h})};
    const ImageId depth = plan.createImage({"overdraw-depth", Format::depth32f, w, h});
    PassBuilder pass = plan.addPass("overdraw");
    pass.color(out.count, LoadOp::clear).depth(depth, LoadOp::clear);
    pass.uniforms(RL_UNIFORMS_VIEW, inputs.viewUniforms);
    bindMaterials(pass, inputs.binder);
    pass.record<DrawnList>({inputs.draws, inputs.binder}, DrawnList::record);
    return out;
}

}  // namespace rushlight

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
    const PassTargets::Color colors[] = {{out.count, LoadOp::clear}};
    PassTargets targets;
    targets.colors = colors;
    targets.depth = {depth, LoadOp::clear};
    plan.addPass<Inputs>("overdraw", targets, inputs, [](const Inputs& in, PassContext& context) {
        context.commands.push(BindUniforms{RL_UNIFORMS_VIEW, 0, in.viewUniforms});
        context.commands.push(BindTexelBuffer{
            RL_TEXTURE_MATERIALS, Format::rgba32ui, {}, in.binder.materials->buffer()});
        in.binder.record(context.commands, *in.draws);
    });
    return out;
}

}  // namespace rushlight

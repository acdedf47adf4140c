#include "renderer/pipeline/stages/blend_stage.h"

namespace rushlight {

Result<BlendStage::Outputs> BlendStage::add(FrameContext& frame, const Inputs& inputs) {
    ForwardPass::Inputs in;
    in.blended = &inputs.lists->blended;
    in.movingEmissive = &inputs.lists->movingEmission;
    in.binder = frame.binder();
    in.viewUniforms = inputs.surface->viewUniforms;
    in.lighting = inputs.lit->lighting;
    in.radiance = inputs.screen->radiance;
    in.depth = inputs.surface->gbuffer.depth;
    in.decals = inputs.surface->decals;
    in.fog = inputs.screen->fog;
    in.worlds = &frame.worlds;
    frame.drawn.push_back(in.blended);
    frame.drawn.push_back(in.movingEmissive);
    const auto forward = forwardPass_.add(frame.plan, in);
    if (!forward) return tl::unexpected(forward.error());
    frame.plan.publish("forward", forward->radiance);
    return Outputs{forward->radiance};
}

}  // namespace rushlight

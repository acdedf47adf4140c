#include "renderer/pipeline/stages/debug_stage.h"

#include <algorithm>

namespace rushlight {
namespace {

void setDepthRange(const FrameContext& frame, DebugViewPass::Inputs& in) {
    const CameraMatrices& camera = frame.camera;
    in.nearestDepth = std::max(camera.nearPlane, 0.01f);  // an orthographic one may be behind
    const Aabb bounds = frame.worlds.bounds();
    if (bounds.isEmpty()) return;
    const float farthest = glm::dot(bounds.center() - camera.position, camera.forward) +
                           glm::dot(glm::abs(camera.forward), bounds.halfExtent());
    in.farthestDepth = std::max(farthest, camera.nearPlane * 2);
}

}  // namespace

Result<void> DebugStage::addChannel(FrameContext& frame, const Inputs& inputs, DebugView view) {
    DebugViewPass::Inputs in;
    in.view = view;
    in.gbuffer = inputs.surface->gbuffer;
    in.ambientOcclusion = frame.plan.find("ambient-occlusion");
    in.shadowMap = inputs.shadows->sunMap;
    in.shadowCascades = inputs.shadows->sunViews;
    in.shadowAtlas = inputs.shadows->atlas;
    in.clusters = inputs.lit->lighting.clusters;
    const LightClusters& clusters = *inputs.lit->clusters;
    in.clusterWords = clusters.recordWords;
    in.clusterMapping = clusters.mapping();
    in.clusterCounts = clusters.counts();
    in.depthDecode = frame.camera.depthDecode;
    in.orthographic = !frame.camera.perspective;
    setDepthRange(frame, in);
    in.target = inputs.target;
    in.data = &frame.uploads;
    if (view == DebugView::overdraw) {
        const auto made = overdrawPass_.add(
            frame.plan, {&inputs.lists->opaque, frame.binder(), inputs.surface->viewUniforms,
                         inputs.target.width, inputs.target.height});
        if (!made) return tl::unexpected(made.error());
        in.overdraw = made->count;
    }
    return viewPass_.add(frame.plan, in);
}

Result<void> DebugStage::addBounds(FrameContext& frame, const Inputs& inputs) {
    return boundsPass_.add(frame.plan, {{&inputs.lists->opaque, &inputs.lists->blended},
                                        &frame.worlds,
                                        inputs.surface->viewUniforms,
                                        inputs.target,
                                        &frame.uploads});
}

Result<void> DebugStage::addOverlay(FrameContext& frame, const FinalTarget& target) {
    const Overlay& overlay = frame.input.overlay;
    return overlayPass_.add(
        frame.plan, {&overlay, frame.stores.textures.find(overlay.image), target, &frame.uploads});
}

}  // namespace rushlight

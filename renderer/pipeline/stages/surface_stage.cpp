#include "renderer/pipeline/stages/surface_stage.h"

#include "renderer/passes/fullscreen.h"
#include "renderer/pipeline/stages/lighting_uniforms.h"

namespace rushlight {

SurfaceStage::SurfaceStage(Device& device)
    : gbufferPass_(device), decalSampler_(trilinearClampSampler(device)) {}

DecalBindings SurfaceStage::bindDecals(FrameContext& frame, interop::ViewUniforms& view) {
    DecalBindings b;
    if (frame.input.decals.empty()) return b;
    const CameraMatrices& camera = frame.camera;
    const DecalStore& store = frame.stores.decals;
    decalClusters_.build(camera, frame.width(), frame.height(), frame.input.decals, store);
    view.decalMapping = decalClusters_.mapping();
    const float half = camera.perspective ? camera.tanHalfY : camera.halfHeight;
    view.decalScale.x = 2 * half / float(frame.height());
    // Where none is in view the shaders are the same and find none in the lists.
    const GpuDecal none{};
    const std::span<const GpuDecal> decals = decalClusters_.decals;
    b.records = frame.uploads.append(decals.empty() ? std::span(&none, 1) : decals);
    b.lists = frame.uploads.append(std::span<const uint32_t>(decalClusters_.lists));
    b.color = store.color();
    b.detail = store.detail();
    b.sampler = decalSampler_;
    return b;
}

Result<SurfaceStage::Outputs> SurfaceStage::add(FrameContext& frame, const Inputs& inputs) {
    Outputs out;
    interop::ViewUniforms view = makeViewUniforms(frame.camera);
    out.decals = bindDecals(frame, view);
    out.viewUniforms = frame.upload(view);
    DrawList& opaque = inputs.lists->opaque;
    frame.drawn.push_back(&opaque);
    const auto gbuffer = gbufferPass_.add(
        frame.plan, {&opaque, frame.binder(), out.viewUniforms, frame.width(), frame.height(),
                     out.decals, &frame.worlds});
    if (!gbuffer) return tl::unexpected(gbuffer.error());
    out.gbuffer = *gbuffer;
    frame.plan.publish("depth", gbuffer->depth);
    return out;
}

}  // namespace rushlight

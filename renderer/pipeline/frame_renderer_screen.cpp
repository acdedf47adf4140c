// What is found in the image of the scene itself, and what is laid over it: ambient occlusion,
// reflections, fog, forward.
#include "renderer/passes/screen/screen_uniforms.h"
#include "renderer/pipeline/frame_renderer.h"

namespace rushlight {

Result<ImageId> FrameRenderer::planAmbientOcclusion(const FrameInput& input,
                                                    const CameraMatrices& camera,
                                                    const GBufferPass::Outputs& gbuffer,
                                                    const LightingBindings& lighting,
                                                    const FrameTarget& target) {
    const FrameSettings& settings = input.settings;
    const bool shown = settings.show == ShownImage::ambientOcclusion;
    const bool needed = settings.ambientOcclusion != AmbientOcclusion::off &&
                        (lighting.features.environment || lighting.features.hemisphere ||
                         lighting.features.irradianceVolume || lighting.features.reflectionProbes);
    if (!shown && !needed) return ImageId{};
    GtaoPass::Inputs in;
    in.gbuffer = gbuffer;
    in.quality = needed ? settings.ambientOcclusion : AmbientOcclusion::medium;
    in.radius = settings.ambientOcclusionRadius;
    in.orthographic = !camera.perspective;
    in.data = &commands_;
    in.width = target.width;
    in.height = target.height;
    in.screen = makeScreenUniforms(camera, in.width, in.height);
    const auto made = gtaoPass_.add(plan_, in);
    if (!made) return tl::unexpected(made.error());
    return made->occlusion;
}

Result<ImageId> FrameRenderer::planReflections(const FrameInput& input,
                                               const CameraMatrices& camera,
                                               const LightingPass::Inputs& lit, ImageId radiance) {
    const ShownImage show = input.settings.show;
    const bool alone = show == ShownImage::reflections;
    const bool mirrors = input.settings.reflections && input.settings.ambientReflections;
    if (!alone && !mirrors) return radiance;
    const interop::ScreenUniforms screen = makeScreenUniforms(camera, lit.width, lit.height);
    const auto pyramid = pyramidPass_.add(
        plan_, {radiance, lit.gbuffer.depth, screen, &commands_, lit.width, lit.height});
    if (!pyramid) return tl::unexpected(pyramid.error());
    const auto made = reflectionsPass_.add(
        plan_, {lit.gbuffer, lit.lighting, lit.ambientOcclusion, lit.localTint, lit.localFlow,
                *pyramid, screen, radiance, alone, &commands_, lit.width, lit.height});
    if (!made) return tl::unexpected(made.error());
    return made->radiance;
}

Result<ImageId> FrameRenderer::planOverLighting(const FrameInput& input,
                                                const CameraMatrices& camera,
                                                const LightingPass::Inputs& lit, ImageId radiance,
                                                BufferRange viewUniforms,
                                                const DecalBindings& onSurfaces) {
    const ShownImage show = input.settings.show;
    if (show == ShownImage::lighting || lit.part != LightingPart::all) return radiance;
    const auto mirrored = planReflections(input, camera, lit, radiance);
    if (!mirrored || show == ShownImage::reflections) return mirrored;
    const auto fog = planFog(input, lit.lighting, radiance, lit.gbuffer.depth);
    if (!fog || show == ShownImage::fog) return fog;
    ForwardPass::Inputs in{&lists_.blended,
                           &lists_.movingEmission,
                           {&geometry, &materials},
                           viewUniforms,
                           lit.lighting,
                           radiance,
                           lit.gbuffer.depth,
                           onSurfaces,
                           *fog};
    const auto forward = forwardPass_.add(plan_, in);
    if (!forward) return tl::unexpected(forward.error());
    return forward->radiance;
}

}  // namespace rushlight

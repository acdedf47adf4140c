// The end of a frame: from linear radiance, or from an image that somebody wants to look into, to
// the final target.

#include "renderer/pipeline/frame_renderer.h"

#include <algorithm>

namespace rushlight {

Result<ImageId> FrameRenderer::planLinearCapture(const FrameInput& input, const FrameOutput& output,
                                                 ImageId radiance, ImageId depth) {
    if (input.settings.show == ShownImage::depth) return depth;
    if (input.settings.show != ShownImage::bloom) return radiance;
    const auto bloom = bloomPass_.add(
        plan_, {radiance, &commands_, output.target.width, output.target.height});
    if (!bloom) return tl::unexpected(bloom.error());
    return bloom->bloom;
}

FinalTarget FrameRenderer::planTarget(const FrameOutput& output) {
    const uint32_t width = output.target.width, height = output.target.height;
    FinalTarget target{{}, width, height, output.target.topRowFirst};
    if (output.offscreen) {
        target.image = plan_.createImage({"frame", Format::rgba8, width, height});
        capturedImage_ = target.image;
        plan_.requestImage(capturedImage_);
    }
    return target;
}

Result<void> FrameRenderer::planOverdraw(const FrameInput& input, const FinalTarget& target,
                                         const CameraMatrices& camera, BufferRange viewUniforms) {
    const auto made = overdrawPass_.add(
        plan_,
        {&lists_.opaque, {&geometry, &materials}, viewUniforms, target.width, target.height});
    if (!made) return tl::unexpected(made.error());
    DebugViewPass::Inputs in;
    in.show = ShownImage::overdraw;
    in.overdraw = made->count;
    in.orthographic = !camera.perspective;
    in.target = target;
    in.data = &commands_;
    if (auto ok = debugViewPass_.add(plan_, in); !ok) return ok;
    return overlayPass_.add(
        plan_, {&input.overlay, textures.find(input.overlay.image), target, &commands_});
}

Result<void> FrameRenderer::planDisplay(const FrameInput& input, const FinalTarget& target,
                                        ImageId radiance) {
    FrameSettings settings = input.settings;
    if (lightingPartOf(settings.show) != LightingPart::all) settings.bloom = false;
    if (settings.show == ShownImage::ambientShare) {  // a factor, no light
        settings.toneMap = ToneMap::none;
        settings.autoExposure = settings.useExposureValue = false;
        settings.exposureScale = 1;
    }
    const bool transparent = input.lighting.background == Background::transparent;
    const bool fxaa = settings.antiAliasing == AntiAliasing::fxaa &&
                      settings.show != ShownImage::tonemap;
    TonemapPass::Inputs tonemap;
    tonemap.radiance = radiance;
    tonemap.settings = &settings;
    tonemap.transparent = transparent;
    tonemap.lumaInAlpha = fxaa && !transparent;
    tonemap.target = target;
    tonemap.data = &commands_;
    if (settings.bloom || settings.autoExposure || settings.show == ShownImage::bloom) {
        const auto bloom = bloomPass_.add(plan_,
                                          {radiance, &commands_, target.width, target.height});
        if (!bloom) return tl::unexpected(bloom.error());
        if (settings.show == ShownImage::bloom)
            tonemap.radiance = bloom->bloom;
        else if (settings.bloom)
            tonemap.bloom = bloom->bloom;
        if (settings.autoExposure) {
            if (settings.cut) exposurePass_.reset();
            const auto exposure = exposurePass_.add(
                plan_, {bloom->smallest, bloom->smallestWidth, bloom->smallestHeight, &commands_,
                        settings.deltaTime});
            if (!exposure) return tl::unexpected(exposure.error());
            tonemap.exposure = exposure->exposure;
        }
    }
    if (!fxaa) return tonemapPass_.add(plan_, tonemap);
    tonemap.target = {plan_.createImage({"display", Format::rgba8, target.width, target.height}),
                      target.width, target.height, false};
    if (auto ok = tonemapPass_.add(plan_, tonemap); !ok) return ok;
    return fxaaPass_.add(plan_, {tonemap.target.image, tonemap.lumaInAlpha, target, &commands_});
}

Result<void> FrameRenderer::planDebugView(const FrameInput& input, const FinalTarget& target,
                                          const CameraMatrices& camera,
                                          const GBufferPass::Outputs& gbuffer,
                                          const LightingBindings& lighting,
                                          ImageId ambientOcclusion) {
    DebugViewPass::Inputs in;
    in.show = input.settings.show;
    in.gbuffer = gbuffer;
    in.ambientOcclusion = ambientOcclusion;
    in.shadowMap = lighting.shadowMap;
    in.shadowCascades = sunViewCount_;
    in.shadowAtlas = lighting.shadowAtlas;
    in.clusters = lighting.clusters;
    in.clusterWords = clusters_.recordWords;
    in.clusterMapping = clusters_.mapping();
    in.clusterCounts = clusters_.counts();
    in.depthDecode = camera.depthDecode;
    in.orthographic = !camera.perspective;
    in.nearestDepth = std::max(camera.nearPlane, 0.01f);  // an orthographic one may be behind the
                                                          // eye
    const Aabb bounds = frameWorlds_.bounds();
    if (!bounds.isEmpty())
        in.farthestDepth = std::max(glm::dot(bounds.center() - camera.position, camera.forward) +
                                        glm::dot(glm::abs(camera.forward), bounds.halfExtent()),
                                    camera.nearPlane * 2);
    in.target = target;
    in.data = &commands_;
    return debugViewPass_.add(plan_, in);
}

}  // namespace rushlight

#include "renderer/pipeline/stages/post_stage.h"

namespace rushlight {

Result<PostStage::Scattered> PostStage::scatter(FrameContext& frame, const FrameSettings& settings,
                                                ImageId radiance) {
    Scattered out;
    if (!settings.bloom && !settings.autoExposure && !frame.plan.wants("bloom")) return out;
    const auto bloom = bloomPass_.add(frame.plan,
                                      {radiance, &frame.uploads, frame.width(), frame.height()});
    if (!bloom) return tl::unexpected(bloom.error());
    frame.plan.publish("bloom", bloom->bloom);
    if (settings.bloom) out.bloom = bloom->bloom;
    if (!settings.autoExposure) return out;
    ViewHistory& history = frame.view.next;
    if (settings.cut) history.exposure.started = false;
    const auto exposure = exposurePass_.add(
        frame.plan, {bloom->smallest, bloom->smallestWidth, bloom->smallestHeight, &frame.uploads,
                     settings.deltaTime, &frame.view.images, &history.exposure});
    if (!exposure) return tl::unexpected(exposure.error());
    out.exposure = exposure->exposure;
    return out;
}

Result<void> PostStage::display(FrameContext& frame, const DisplayInputs& inputs) {
    const bool transparent = frame.input.lighting.background == Background::transparent;
    const bool fxaa = inputs.settings->antiAliasing == AntiAliasing::fxaa;
    TonemapPass::Inputs tonemap;
    tonemap.radiance = inputs.radiance;
    tonemap.bloom = inputs.scattered.bloom;
    tonemap.exposure = inputs.scattered.exposure;
    tonemap.settings = inputs.settings;
    tonemap.transparent = transparent;
    tonemap.lumaInAlpha = fxaa && !transparent;
    tonemap.target = inputs.target;
    tonemap.data = &frame.uploads;
    if (!fxaa) return tonemapPass_.add(frame.plan, tonemap);
    const uint32_t width = inputs.target.width, height = inputs.target.height;
    tonemap.target = {frame.plan.createImage({"display", Format::rgba8, width, height}), width,
                      height, false};
    if (auto ok = tonemapPass_.add(frame.plan, tonemap); !ok) return ok;
    return fxaaPass_.add(
        frame.plan, {tonemap.target.image, tonemap.lumaInAlpha, inputs.target, &frame.uploads});
}

}  // namespace rushlight

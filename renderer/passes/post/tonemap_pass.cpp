#include "renderer/passes/post/tonemap_pass.h"

#include "shaders/interop/bindings.h"

#include <cmath>

namespace rushlight {

float exposureFactor(const FrameSettings& settings) {
    if (settings.autoExposure) return 1;
    if (!settings.useExposureValue) return settings.exposureScale;
    return 1.0f / (1.2f * std::exp2(settings.exposureValue));
}

TonemapPass::TonemapPass(Device& device)
    : pipelines_(device, "tonemap", "passes/post/tonemap.frag"),
      linear_(linearClampSampler(device)),
      nearest_(nearestClampSampler(device)) {}

Result<void> TonemapPass::add(FramePlan& plan, const Inputs& inputs) {
    std::string_view defines[5];
    size_t count = 0;
    switch (inputs.settings->toneMap) {
        case ToneMap::none: break;
        case ToneMap::neutral: defines[count++] = "TONE_MAP_NEUTRAL"; break;
        case ToneMap::agx: defines[count++] = "TONE_MAP_AGX"; break;
        case ToneMap::aces: defines[count++] = "TONE_MAP_ACES"; break;
    }
    if (inputs.bloom) defines[count++] = "BLOOM";
    if (inputs.exposure) defines[count++] = "AUTO_EXPOSURE";
    if (inputs.settings->dither) defines[count++] = "DITHER";
    if (inputs.transparent)
        defines[count++] = "TRANSPARENT";
    else if (inputs.lumaInAlpha)
        defines[count++] = "LUMA_IN_ALPHA";
    const auto pipeline = pipelines_.find({defines, count});
    if (!pipeline) return tl::unexpected(pipeline.error());

    interop::PassUniforms u{};
    u.settings.x = inputs.settings->bloomStrength;
    u.settings.y = exposureFactor(*inputs.settings);
    u.counts.w = inputs.target.topRowFirst ? 1.0f : 0.0f;
    PassBuilder pass = plan.addPass("tonemap");
    inputs.target.bind(pass, LoadOp::discard);
    pass.uniforms(RL_UNIFORMS_PASS, appendUniforms(*inputs.data, u));
    pass.sample(RL_TEXTURE_SOURCE0, inputs.radiance, nearest_);
    pass.sample(RL_TEXTURE_SOURCE1, inputs.bloom, linear_);
    pass.sample(RL_TEXTURE_SOURCE2, inputs.exposure, nearest_);
    pass.fullscreen(*pipeline);
    return {};
}

}  // namespace rushlight

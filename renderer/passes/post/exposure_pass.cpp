#include "renderer/passes/post/exposure_pass.h"

#include "shaders/interop/bindings.h"

#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kMeansSide = 4;  // as exposure.frag reads them
constexpr const char* kTexels[2] = {"exposure.0", "exposure.1"};
constexpr float kMiddleGrey = 0.18f;
constexpr float kSpeed = 2.0f;  // 1/s: 86 % of the way in a second
// From full sun in lux to a room by candles; what is darker is meant to be dark.
constexpr float kLowestFactor = 1e-6f;
constexpr float kHighestFactor = 32.0f;

}  // namespace

ExposurePass::ExposurePass(Device& device)
    : device_(device),
      luminance_(device, "luminance", "passes/post/luminance.frag"),
      exposure_(device, "exposure", "passes/post/exposure.frag"),
      linear_(linearClampSampler(device)),
      nearest_(nearestClampSampler(device)) {}

// Two texels in turn: a frame that fails leaves the one of the frame before as it was.
Result<ImageId> ExposurePass::import(FramePlan& plan, ImageHistory& images, uint32_t texel,
                                     const char* name) {
    const uint32_t before = images.generationOf(kTexels[texel]);
    const auto kept = images.get({kTexels[texel], Format::r32f, 1, 1});
    if (!kept) return tl::unexpected(kept.error());
    if (before == 0) {
        const float none = 0;
        TextureRegion region;
        region.width = region.height = 1;
        device_.write(kept->texture, region, std::as_bytes(std::span(&none, 1)));
    }
    return plan.importImage({name, Format::r32f, 1, 1}, kept->texture);
}

Result<ExposurePass::Outputs> ExposurePass::add(FramePlan& plan, const Inputs& inputs) {
    const auto luminance = luminance_.find({});
    if (!luminance) return tl::unexpected(luminance.error());
    const auto exposure = exposure_.find({});
    if (!exposure) return tl::unexpected(exposure.error());

    const ImageId means = plan.createImage({"log-luminance", Format::r32f, kMeansSide, kMeansSide});
    ExposureHistory& history = *inputs.history;
    const auto previous = import(plan, *inputs.images, history.current, "exposure-before");
    if (!previous) return tl::unexpected(previous.error());
    history.current ^= 1;
    const auto now = import(plan, *inputs.images, history.current, "exposure");
    if (!now) return tl::unexpected(now.error());

    interop::PassUniforms u{};
    u.sourceTexel = vec4(1.0f / float(inputs.sourceWidth), 1.0f / float(inputs.sourceHeight), 0, 0);
    const float share = history.started ? 1.0f - std::exp(-kSpeed * inputs.deltaTime) : 1.0f;
    history.started = true;
    u.settings = vec4(share, kLowestFactor, kHighestFactor, kMiddleGrey);
    const BufferRange uniforms = appendUniforms(*inputs.data, u);

    {
        PassBuilder pass = plan.addPass("luminance");
        pass.color(means);
        pass.uniforms(RL_UNIFORMS_PASS, uniforms);
        pass.sample(RL_TEXTURE_SOURCE0, inputs.source, linear_);
        pass.fullscreen(*luminance);
    }
    PassBuilder pass = plan.addPass("exposure");
    pass.color(*now);
    pass.uniforms(RL_UNIFORMS_PASS, uniforms);
    pass.sample(RL_TEXTURE_SOURCE0, means, nearest_);
    pass.sample(RL_TEXTURE_SOURCE1, *previous, nearest_);
    pass.fullscreen(*exposure);
    return Outputs{*now};
}

}  // namespace rushlight

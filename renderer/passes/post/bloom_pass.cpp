#include "renderer/passes/post/bloom_pass.h"

#include "shaders/interop/bindings.h"

#include <algorithm>
#include <array>

namespace rushlight {
namespace {

constexpr uint32_t kMaxLevels = 6;
constexpr uint32_t kSmallestSide = 4;
constexpr float kSpread = 0.65f;  // share of the coarser level at each step up
constexpr std::array<const char*, kMaxLevels> kImageNames = {"bloom.0", "bloom.1", "bloom.2",
                                                             "bloom.3", "bloom.4", "bloom.5"};
constexpr std::array<const char*, kMaxLevels> kDownNames = {
    "bloom.down.0", "bloom.down.1", "bloom.down.2", "bloom.down.3", "bloom.down.4", "bloom.down.5"};
constexpr std::array<const char*, kMaxLevels> kUpNames = {"bloom.up.0", "bloom.up.1", "bloom.up.2",
                                                          "bloom.up.3", "bloom.up.4", "bloom.up.5"};

struct Level {
    ImageId image;
    uint32_t width, height;
};

}  // namespace

BloomPass::BloomPass(Device& device)
    : down_(device, "bloom-down", "passes/post/bloom_downsample.frag"),
      up_(device, "bloom-up", "passes/post/bloom_upsample.frag", BlendMode::premultiplied),
      linear_(linearClampSampler(device)) {}

Result<BloomPass::Outputs> BloomPass::add(FramePlan& plan, const Inputs& inputs) {
    constexpr std::string_view kFirst[] = {"FIRST"};
    const auto first = down_.find(kFirst);
    const auto down = down_.find({});
    const auto up = up_.find({});
    for (const auto* pipeline : {&first, &down, &up})
        if (!*pipeline) return tl::unexpected(pipeline->error());

    const auto step = [&](const char* name, const Level& from, const Level& to, LoadOp load,
                          PipelineHandle pipeline) {
        interop::PassUniforms u{};
        u.sourceTexel = vec4(1.0f / float(from.width), 1.0f / float(from.height), 0, 0);
        u.settings.x = kSpread;
        PassBuilder pass = plan.addPass(name);
        pass.color(to.image, load);
        pass.uniforms(RL_UNIFORMS_PASS, appendUniforms(*inputs.data, u));
        pass.sample(RL_TEXTURE_SOURCE0, from.image, linear_);
        pass.fullscreen(pipeline);
    };

    std::array<Level, kMaxLevels> levels;
    Level from{inputs.radiance, inputs.width, inputs.height};
    uint32_t count = 0;
    do {
        Level& to = levels[count];
        to.width = std::max(from.width / 2, 1u);
        to.height = std::max(from.height / 2, 1u);
        to.image = plan.createImage({kImageNames[count], Format::r11g11b10f, to.width, to.height});
        step(kDownNames[count], from, to, LoadOp::discard, count == 0 ? *first : *down);
        from = to;
        ++count;
    } while (count < kMaxLevels && std::min(from.width, from.height) / 2 >= kSmallestSide);
    for (uint32_t i = count - 1; i > 0; --i)
        step(kUpNames[i - 1], levels[i], levels[i - 1], LoadOp::keep, *up);
    return Outputs{levels[0].image, from.image, from.width, from.height};
}

}  // namespace rushlight

#include "renderer/passes/screen/gtao_pass.h"

#include "renderer/passes/screen/screen_uniforms.h"
#include "shaders/interop/bindings.h"

#include <array>

namespace rushlight {
namespace {

// By AmbientOcclusion: low, medium, high. A slice looks to two sides, so many steps each.
constexpr std::array<std::string_view, 3> kSlices = {"OCCLUSION_SLICES 2", "OCCLUSION_SLICES 2",
                                                     "OCCLUSION_SLICES 4"};
constexpr std::array<std::string_view, 3> kSteps = {"OCCLUSION_STEPS 2", "OCCLUSION_STEPS 3",
                                                    "OCCLUSION_STEPS 6"};
// Occluders lose weight from this share of the radius on, so that none pops in or out. What is
// found is then what rays find that count a hit fully up to 0.4 of the radius, and from there less
// with the square of its distance: one horizon stands for all that is below it, with a weight of
// its own, which makes it sink more than the mean of theirs.
constexpr float kFullWeight = 0.7f;
// The search goes no further than this share of the picture's height: its few steps would miss too
// much.
constexpr float kLongestSearch = 0.25f;
// How far a horizon sinks for each place behind it: 0 takes every edge for a wall without end.
constexpr float kThinness = 0.05f;

}  // namespace

GtaoPass::GtaoPass(Device& device)
    : search_(device, "gtao", "passes/screen/gtao.frag", BlendMode::off,
              "passes/screen/screen_space.vert"),
      denoise_(device, "gtao-denoise", "passes/screen/gtao_denoise.frag", BlendMode::off,
               "passes/screen/screen_space.vert"),
      nearest_(nearestClampSampler(device)) {}

Result<GtaoPass::Outputs> GtaoPass::add(FramePlan& plan, const Inputs& inputs) {
    const size_t quality = size_t(inputs.quality) - 1;
    const std::string_view defines[] = {kSlices[quality], kSteps[quality], "ORTHOGRAPHIC"};
    const auto search = search_.find({defines, inputs.orthographic ? size_t(3) : size_t(2)});
    if (!search) return tl::unexpected(search.error());
    const auto denoise = denoise_.find({});
    if (!denoise) return tl::unexpected(denoise.error());

    interop::ScreenUniforms screen = inputs.screen;
    // Weights fall with the square of the distance, from 1 at kFullWeight of the radius to 0 at it.
    const float fall = 1 / (1 - kFullWeight * kFullWeight);
    screen.settings = {inputs.radius, fall, fall / (inputs.radius * inputs.radius), kThinness};
    screen.back.w = kLongestSearch * float(inputs.height);
    const BufferRange uniforms = inputs.data->append(
        std::span<const interop::ScreenUniforms>(&screen, 1));
    const uint32_t w = halfSize(inputs.width), h = halfSize(inputs.height);
    const ImageId noisy = plan.createImage({"gtao-pattern", Format::rgba32f, w, h});
    const ImageId occlusion = plan.createImage({"ambient-occlusion", Format::rgba32f, w, h});
    {
        PassBuilder pass = plan.addPass("gtao");
        pass.color(noisy);
        pass.uniforms(RL_UNIFORMS_PASS, uniforms);
        pass.sample(RL_TEXTURE_GBUFFER1, inputs.gbuffer.target1, nearest_);
        pass.sample(RL_TEXTURE_DEPTH, inputs.gbuffer.depth, nearest_);
        pass.fullscreen(*search);
    }
    PassBuilder pass = plan.addPass("gtao.denoise");
    pass.color(occlusion);
    pass.uniforms(RL_UNIFORMS_PASS, uniforms);
    pass.sample(RL_TEXTURE_SOURCE0, noisy, nearest_);
    pass.fullscreen(*denoise);
    return Outputs{occlusion};
}

}  // namespace rushlight

#include "renderer/passes/screen/pyramid_pass.h"

#include "renderer/passes/screen/screen_uniforms.h"
#include "shaders/interop/bindings.h"

namespace rushlight {

PyramidPass::PyramidPass(Device& device)
    : base_(device, "pyramid-base", "passes/screen/pyramid_base.frag", BlendMode::off,
            "passes/screen/screen_space.vert"),
      levels_(device, "pyramid", "passes/screen/pyramid.frag", BlendMode::off,
              "passes/screen/screen_space.vert"),
      nearest_(nearestClampSampler(device)),
      linear_(linearClampSampler(device)) {}

Result<PyramidPass::Outputs> PyramidPass::add(FramePlan& plan, const Inputs& inputs) {
    const auto base = base_.find({});
    if (!base) return tl::unexpected(base.error());
    const auto levels = levels_.find({});
    if (!levels) return tl::unexpected(levels.error());

    const BufferRange uniforms = inputs.data->append(
        std::span<const interop::ScreenUniforms>(&inputs.screen, 1));
    const uint32_t w = halfSize(inputs.width), h = halfSize(inputs.height);
    const uint32_t fullWidth = w + halfSize(w), fullHeight = (h + 15) & ~15u;
    struct Source {
        uint32_t slot;
        ImageId image;
        SamplerHandle sampler;
    };
    const auto step = [&](const char* name, PipelineHandle pipeline, const Source(&sources)[2],
                          const Outputs& to) {
        PassBuilder pass = plan.addPass(name);
        pass.color(to.radiance).color(to.nearest);
        pass.uniforms(RL_UNIFORMS_PASS, uniforms);
        for (const Source& source : sources) pass.sample(source.slot, source.image, source.sampler);
        pass.fullscreen(pipeline);
    };
    const Outputs half{plan.createImage({"pyramid-base-radiance", Format::rgba16f, w, h}),
                       plan.createImage({"pyramid-base-depth", Format::r32f, w, h})};
    step("pyramid.base", *base,
         {{RL_TEXTURE_SOURCE0, inputs.radiance, linear_},
          {RL_TEXTURE_DEPTH, inputs.depth, nearest_}},
         half);
    const Outputs out{
        plan.createImage({"pyramid-radiance", Format::rgba16f, fullWidth, fullHeight}),
        plan.createImage({"pyramid-depth", Format::r32f, fullWidth, fullHeight})};
    step("pyramid.levels", *levels,
         {{RL_TEXTURE_SOURCE0, half.radiance, linear_},
          {RL_TEXTURE_SOURCE1, half.nearest, nearest_}},
         out);
    return out;
}

}  // namespace rushlight

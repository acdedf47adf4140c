#include "renderer/passes/post/fxaa_pass.h"

#include "shaders/interop/bindings.h"

namespace rushlight {

Result<void> FxaaPass::add(FramePlan& plan, const Inputs& inputs) {
    constexpr std::string_view kLuma[] = {"LUMA_IN_ALPHA"};
    const auto pipeline = pipelines_.find(std::span(kLuma, inputs.lumaInAlpha ? 1 : 0));
    if (!pipeline) return tl::unexpected(pipeline.error());
    interop::PassUniforms u{};
    u.sourceTexel = vec4(1.0f / float(inputs.target.width), 1.0f / float(inputs.target.height), 0,
                         0);
    u.counts.w = inputs.target.topRowFirst ? 1.0f : 0.0f;
    PassBuilder pass = plan.addPass("fxaa");
    inputs.target.bind(pass, LoadOp::discard);
    pass.uniforms(RL_UNIFORMS_PASS, appendUniforms(*inputs.data, u));
    pass.sample(RL_TEXTURE_SOURCE0, inputs.display, linear_);
    pass.fullscreen(*pipeline);
    return {};
}

}  // namespace rushlight

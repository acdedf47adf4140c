#include "renderer/passes/debug/debug_view_pass.h"

#include "shaders/interop/bindings.h"

namespace rushlight {
namespace {

std::string_view defineOf(DebugView view) {
    switch (view) {
        case DebugView::baseColor: return "SHOW_BASE_COLOR";
        case DebugView::metallic: return "SHOW_METALLIC";
        case DebugView::roughness: return "SHOW_ROUGHNESS";
        case DebugView::normal: return "SHOW_NORMAL";
        case DebugView::emissive: return "SHOW_EMISSIVE";
        case DebugView::occlusion: return "SHOW_OCCLUSION";
        case DebugView::velocity: return "SHOW_VELOCITY";
        case DebugView::depth: return "SHOW_DEPTH";
        case DebugView::overdraw: return "SHOW_OVERDRAW";
        case DebugView::shadow: return "SHOW_SHADOW";
        case DebugView::clusters: return "SHOW_CLUSTERS";
        case DebugView::ambientOcclusion: return "SHOW_AMBIENT_OCCLUSION";
        default: return {};
    }
}

interop::PassUniforms uniformsOf(const DebugViewPass::Inputs& in) {
    const float width = float(in.target.width), height = float(in.target.height);
    interop::PassUniforms u{};
    u.sourceTexel = vec4(1 / width, 1 / height, in.depthDecode);
    if (in.view == DebugView::shadow) {
        const uint32_t cells = in.shadowCascades + (in.shadowAtlas ? 1 : 0);
        u.counts.x = float(cells);
        u.counts.y = float(in.shadowCascades);
        u.settings.x = width / float(cells) / height;
    } else if (in.view == DebugView::clusters) {
        u.settings = in.clusterMapping;
        u.counts = in.clusterCounts;
    } else {
        u.settings = vec4(in.nearestDepth, in.farthestDepth, 0, 0);
    }
    u.counts.w = in.target.topRowFirst ? 1.0f : 0.0f;
    return u;
}

}  // namespace

DebugViewPass::DebugViewPass(Device& device)
    : pipelines_(device, "debug-view", "passes/debug/debug_view.frag"),
      nearest_(nearestClampSampler(device)) {}

bool DebugViewPass::shows(DebugView view) { return !defineOf(view).empty(); }

Result<void> DebugViewPass::add(FramePlan& plan, const Inputs& inputs) {
    const bool shadow = inputs.view == DebugView::shadow;
    const bool clusters = inputs.view == DebugView::clusters;
    const bool ambient = inputs.view == DebugView::ambientOcclusion;
    const bool overdraw = inputs.view == DebugView::overdraw;
    const bool nothing = (shadow && !inputs.shadowMap && !inputs.shadowAtlas) ||
                         (clusters && !inputs.clusters.size) ||
                         (ambient && !inputs.ambientOcclusion) || (overdraw && !inputs.overdraw);
    std::string_view defines[3];
    size_t count = 0;
    defines[count++] = nothing ? "SHOW_NOTHING" : defineOf(inputs.view);
    if (clusters && inputs.clusterWords > 1) defines[count++] = "MODULATED_LIGHTS";
    if (inputs.orthographic) defines[count++] = "ORTHOGRAPHIC";
    const auto pipeline = pipelines_.find({defines, count});
    if (!pipeline) return tl::unexpected(pipeline.error());

    PassBuilder pass = plan.addPass("debug-view");
    inputs.target.bind(pass, LoadOp::discard);
    pass.uniforms(RL_UNIFORMS_PASS, appendUniforms(*inputs.data, uniformsOf(inputs)));
    if (shadow && !nothing) {
        // Both units need a texture; what is not there has no cell.
        const ImageId map = inputs.shadowMap ? inputs.shadowMap : inputs.shadowAtlas;
        const ImageId atlas = inputs.shadowAtlas ? inputs.shadowAtlas : inputs.shadowMap;
        pass.sample(RL_TEXTURE_SOURCE0, map, nearest_);
        pass.sample(RL_TEXTURE_SOURCE1, atlas, nearest_);
    } else if (overdraw && !nothing) {
        pass.sample(RL_TEXTURE_SOURCE0, inputs.overdraw, nearest_);
    } else {
        const GBufferPass::Outputs& g = inputs.gbuffer;
        if (ambient && !nothing)  // which does without the base colour
            pass.sample(RL_TEXTURE_AMBIENT_OCCLUSION, inputs.ambientOcclusion, nearest_);
        else
            pass.sample(RL_TEXTURE_GBUFFER0, g.target0, nearest_);
        pass.sample(RL_TEXTURE_GBUFFER1, g.target1, nearest_);
        pass.sample(RL_TEXTURE_GBUFFER2, g.target2, nearest_);
        pass.sample(RL_TEXTURE_DEPTH, g.depth, nearest_);
    }
    if (clusters) pass.texels(RL_TEXTURE_CLUSTERS, Format::r32ui, inputs.clusters);
    pass.fullscreen(*pipeline);
    return {};
}

}  // namespace rushlight

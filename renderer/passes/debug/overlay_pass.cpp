#include "renderer/passes/debug/overlay_pass.h"

#include "shaders/interop/bindings.h"

#include <algorithm>
#include <string>

namespace rushlight {

OverlayPass::OverlayPass(Device& device) : device_(device), linear_(linearClampSampler(device)) {}

Result<void> OverlayPass::check(const Inputs& inputs) const {
    const Overlay& o = *inputs.overlay;
    const auto wrong = [](const std::string& what) {
        return fail("overlay", what, ErrorKind::wrongUse);
    };
    if (!inputs.image || !inputs.image->array)
        return wrong("it has triangles but no image, or the image is a stale handle.");
    for (const OverlayBatch& batch : o.batches)
        if (batch.firstIndex > o.indices.size() ||
            batch.indexCount > o.indices.size() - batch.firstIndex)
            return wrong("a batch of " + std::to_string(batch.indexCount) + " indices from " +
                         std::to_string(batch.firstIndex) + " on goes beyond the " +
                         std::to_string(o.indices.size()) + " there are.");
    for (const uint32_t index : o.indices)
        if (index >= o.vertices.size())
            return wrong("index " + std::to_string(index) +
                         " is not below the number of "
                         "vertices, " +
                         std::to_string(o.vertices.size()) + ".");
    return {};
}

Result<void> OverlayPass::add(FramePlan& plan, const Inputs& inputs) {
    const Overlay& overlay = *inputs.overlay;
    if (overlay.batches.empty() || overlay.indices.empty()) return {};
    if (auto ok = check(inputs); !ok) return ok;
    if (!pipeline_) {
        PipelineDesc desc;
        desc.label = "overlay";
        desc.vertexShader = "passes/debug/overlay.vert";
        desc.fragmentShader = "passes/debug/overlay.frag";
        desc.layout = VertexLayout::overlay;
        desc.blend = BlendMode::premultiplied;
        auto pipeline = device_.createPipeline(desc);
        if (!pipeline) return tl::unexpected(pipeline.error());
        pipeline_ = *pipeline;
    }

    const int width = int(inputs.target.width), height = int(inputs.target.height);
    batches_.clear();
    for (const OverlayBatch& batch : overlay.batches) {
        const ivec2 low = glm::clamp(batch.clipLow, ivec2(0), ivec2(width, height));
        const ivec2 high = glm::clamp(batch.clipHigh, low, ivec2(width, height));
        if (high.x == low.x || high.y == low.y || batch.indexCount == 0) continue;
        const int y = inputs.target.topRowFirst ? low.y : height - high.y;
        batches_.push_back({{low.x, y, high.x - low.x, high.y - low.y},
                            {batch.indexCount, 1, batch.firstIndex, 0, 0}});
    }
    if (batches_.empty()) return {};

    interop::PassUniforms u{};
    u.sourceTexel = vec4(2.0f / float(width), 2.0f / float(height), 0, 0);
    u.settings = vec4(inputs.target.topRowFirst ? 1 : 0, inputs.image->layer, 0, 0);
    Payload payload;
    payload.pipeline = pipeline_;
    payload.vertices = inputs.data->append(overlay.vertices);
    payload.indices = inputs.data->append(overlay.indices);
    payload.batches = &batches_;
    PassBuilder pass = plan.addPass("overlay");
    inputs.target.bind(pass, LoadOp::keep);
    pass.uniforms(RL_UNIFORMS_PASS, appendUniforms(*inputs.data, u));
    pass.texture(RL_TEXTURE_SOURCE0, inputs.image->array, linear_);
    pass.record<Payload>(payload, record);
    return {};
}

void OverlayPass::record(const Payload& p, CommandBuffer& commands) {
    commands.push(SetPipeline{p.pipeline});
    commands.push(SetVertexStream{RL_STREAM_POSITION, sizeof(OverlayVertex), p.vertices});
    commands.push(SetIndexStream{p.indices});
    for (const Scissor& batch : *p.batches) {
        commands.push(batch.rectangle);
        commands.push(DrawIndexed{batch.command});
    }
}

}  // namespace rushlight

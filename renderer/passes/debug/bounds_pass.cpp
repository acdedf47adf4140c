#include "renderer/passes/debug/bounds_pass.h"

#include "shaders/interop/bindings.h"

namespace rushlight {
namespace {

constexpr uint32_t kVerticesPerBox = 24;  // twelve edges

struct Payload {
    PipelineHandle pipeline;
    uint32_t boxCount;
};

void record(const Payload& payload, CommandBuffer& commands) {
    commands.push(SetPipeline{payload.pipeline});
    commands.push(Draw{kVerticesPerBox * payload.boxCount, 1, 0});
}

}  // namespace

Result<void> BoundsPass::add(FramePlan& plan, const Inputs& inputs) {
    if (!pipeline_) {
        PipelineDesc desc;
        desc.label = "bounds";
        desc.vertexShader = "passes/debug/bounds.vert";
        desc.fragmentShader = "passes/debug/bounds.frag";
        desc.lines = true;
        auto pipeline = device_.createPipeline(desc);
        if (!pipeline) return tl::unexpected(pipeline.error());
        pipeline_ = *pipeline;
    }
    boxes_.clear();
    for (const DrawList* list : inputs.lists)
        for (const VisibleItem& item : list->items) {
            const Aabb& box = inputs.worlds->record(item.object).box;
            boxes_.push_back(vec4(box.center(), 0));
            boxes_.push_back(vec4(box.halfExtent(), 0));
        }
    if (boxes_.empty()) return {};
    PassBuilder pass = plan.addPass("bounds");
    inputs.target.bind(pass, LoadOp::keep);
    pass.uniforms(RL_UNIFORMS_VIEW, inputs.viewUniforms);
    pass.texels(RL_TEXTURE_LIGHTS, Format::rgba32f,
                inputs.data->append(std::span<const vec4>(boxes_)));
    pass.record<Payload>({pipeline_, uint32_t(boxes_.size() / 2)}, record);
    return {};
}

}  // namespace rushlight

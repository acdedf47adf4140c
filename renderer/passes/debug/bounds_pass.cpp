#include "renderer/passes/debug/bounds_pass.h"

#include "shaders/interop/bindings.h"

namespace rushlight {
namespace {

constexpr uint32_t kVerticesPerBox = 24;  // twelve edges

struct Payload {
    PipelineHandle pipeline;
    BufferRange viewUniforms, boxes;
    uint32_t boxCount;
};

void record(const Payload& payload, PassContext& context) {
    context.commands.push(SetPipeline{payload.pipeline});
    context.commands.push(BindUniforms{RL_UNIFORMS_VIEW, 0, payload.viewUniforms});
    context.commands.push(BindTexelBuffer{RL_TEXTURE_LIGHTS, Format::rgba32f, {}, payload.boxes});
    context.commands.push(Draw{kVerticesPerBox * payload.boxCount, 1, 0});
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
    PassTargets::Color color;
    plan.addPass<Payload>(
        "bounds", inputs.target.targets(color, LoadOp::keep),
        {pipeline_, inputs.viewUniforms, inputs.data->append(std::span<const vec4>(boxes_)),
         uint32_t(boxes_.size() / 2)},
        record);
    return {};
}

}  // namespace rushlight

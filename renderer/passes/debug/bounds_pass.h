#pragma once
// The world-space boxes of the visible objects as lines over the picture.

#include "renderer/plan/final_target.h"
#include "renderer/visibility/draw_list.h"

namespace rushlight {

class BoundsPass {
public:
    struct Inputs {
        const DrawList* lists[2] = {};  ///< whose instances are shown
        const FrameWorlds* worlds = nullptr;
        BufferRange viewUniforms;
        FinalTarget target;  ///< keeps what it holds
        CommandBuffer* data = nullptr;
    };

    explicit BoundsPass(Device& device) : device_(device) {}
    Result<void> add(FramePlan& plan, const Inputs& inputs);

private:
    Device& device_;
    PipelineHandle pipeline_;
    std::vector<vec4> boxes_;
};

}  // namespace rushlight

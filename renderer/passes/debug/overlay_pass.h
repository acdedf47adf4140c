#pragma once
// The user interface, over everything, in sRGB.

#include "renderer/frame/frame_input.h"
#include "renderer/passes/fullscreen.h"
#include "renderer/plan/final_target.h"
#include "renderer/resources/texture_store.h"

namespace rushlight {

class OverlayPass {
public:
    struct Inputs {
        const Overlay* overlay = nullptr;      ///< read during add() alone
        const ImageLocation* image = nullptr;  ///< of Overlay::image
        FinalTarget target;                    ///< keeps what it holds
        CommandBuffer* data = nullptr;
    };

    explicit OverlayPass(Device& device);
    /// Adds nothing for an empty overlay. Fails when a batch or an index is out of range, or the
    /// image is missing.
    Result<void> add(FramePlan& plan, const Inputs& inputs);

private:
    Result<void> check(const Inputs& inputs) const;

    struct Scissor {
        SetScissor rectangle;
        DrawIndexedCommand command;
    };
    struct Payload {
        PipelineHandle pipeline;
        BufferRange vertices, indices;
        const std::vector<Scissor>* batches;
    };
    static void record(const Payload& payload, CommandBuffer& commands);

    Device& device_;
    PipelineHandle pipeline_;
    SamplerHandle linear_;
    std::vector<Scissor> batches_;
};

}  // namespace rushlight

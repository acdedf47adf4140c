#pragma once
// Pictures of what a frame made on its way, in place of the frame; and what is drawn over it.

#include "renderer/passes/debug/bounds_pass.h"
#include "renderer/passes/debug/debug_view_pass.h"
#include "renderer/passes/debug/overdraw_pass.h"
#include "renderer/passes/debug/overlay_pass.h"
#include "renderer/pipeline/stages/lighting_stage.h"

namespace rushlight {

class DebugStage {
public:
    struct Inputs {
        Visibility::Lists* lists = nullptr;
        const SurfaceStage::Outputs* surface = nullptr;
        const ShadowStage::Outputs* shadows = nullptr;
        const LightingStage::Outputs* lit = nullptr;
        FinalTarget target;
    };

    explicit DebugStage(Device& device)
        : viewPass_(device), boundsPass_(device), overdrawPass_(device), overlayPass_(device) {}
    /// A channel in false colours as the picture.
    Result<void> addChannel(FrameContext& frame, const Inputs& inputs, DebugView view);
    /// The visible objects' boxes over the picture.
    Result<void> addBounds(FrameContext& frame, const Inputs& inputs);
    /// The host's user interface over everything.
    Result<void> addOverlay(FrameContext& frame, const FinalTarget& target);

private:
    DebugViewPass viewPass_;
    BoundsPass boundsPass_;
    OverdrawPass overdrawPass_;
    OverlayPass overlayPass_;
};

}  // namespace rushlight

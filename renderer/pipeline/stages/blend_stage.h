#pragma once
// What the G-buffer cannot hold, over the lit scene.

#include "renderer/passes/blend/forward_pass.h"
#include "renderer/pipeline/stages/lighting_stage.h"
#include "renderer/pipeline/stages/screen_stage.h"

namespace rushlight {

class BlendStage {
public:
    struct Inputs {
        Visibility::Lists* lists = nullptr;
        const SurfaceStage::Outputs* surface = nullptr;
        const LightingStage::Outputs* lit = nullptr;
        const ScreenStage::Outputs* screen = nullptr;
    };
    struct Outputs {
        ImageId radiance;  ///< published as "forward"
    };

    explicit BlendStage(Device& device) : forwardPass_(device) {}
    Result<Outputs> add(FrameContext& frame, const Inputs& inputs);

private:
    ForwardPass forwardPass_;
};

}  // namespace rushlight

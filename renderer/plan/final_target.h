#pragma once

#include "renderer/plan/frame_plan.h"

namespace rushlight {

/// Where the last passes of a frame draw: an image of the plan, or the host's framebuffer.
struct FinalTarget {
    ImageId image;  ///< RGBA8, sRGB encoded by the shader; null for the host's framebuffer
    uint32_t width = 0;
    uint32_t height = 0;
    bool topRowFirst = false;  ///< FrameTarget::topRowFirst

    /// Makes it the target of a pass.
    void bind(PassBuilder& pass, LoadOp load) const {
        if (image)
            pass.color(image, load);
        else
            pass.frameTarget(width, height);
    }
};

}  // namespace rushlight

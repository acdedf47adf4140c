#pragma once

#include "renderer/plan/frame_plan.h"

namespace rushlight {

/// Where the last passes of a frame draw: an image of the plan, or the host's framebuffer.
struct FinalTarget {
    ImageId image;  ///< RGBA8, sRGB encoded by the shader; null for the host's framebuffer
    uint32_t width = 0;
    uint32_t height = 0;
    bool topRowFirst = false;  ///< FrameTarget::topRowFirst

    /// The targets of a pass that draws here. `color` must live as long as the result.
    PassTargets targets(PassTargets::Color& color, LoadOp load) const {
        PassTargets t;
        if (image) {
            color = {image, load};
            t.colors = {&color, 1};
        } else {
            t.toFrameTarget = true;
            t.frameWidth = width;
            t.frameHeight = height;
        }
        return t;
    }
};

}  // namespace rushlight

#pragma once
// The lit scene and its nearest depths in five levels from half the size down, all in one image
// each: what screen-space reflections march through and what they blur with. Made for a frame that
// uses it alone.

#include "renderer/passes/fullscreen.h"
#include "shaders/interop/screen_uniforms.h"

namespace rushlight {

class PyramidPass {
public:
    struct Inputs {
        ImageId radiance, depth;         ///< of the frame's size
        interop::ScreenUniforms screen;  ///< makeScreenUniforms
        CommandBuffer* data = nullptr;   ///< gets the uniforms
        uint32_t width = 0, height = 0;  ///< of the frame
    };
    struct Outputs {
        ImageId radiance;  ///< RGBA16F, the mean; drawn in shaders/common/screen/pyramid.glsl
        ImageId nearest;   ///< R32F, device depth (reversed): the largest
    };

    explicit PyramidPass(Device& device);
    Result<Outputs> add(FramePlan& plan, const Inputs& inputs);

private:
    FullscreenPipelines base_, levels_;
    SamplerHandle nearest_, linear_;
};

}  // namespace rushlight

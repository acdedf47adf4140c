#pragma once
// The view as passes see it that look things up in the image of the scene:
// shaders/common/screen/screen_space.glsl.

#include "renderer/geometry/view_math.h"
#include "shaders/interop/screen_uniforms.h"

namespace rushlight {

/// Everything but `settings`. `width` and `height` are the frame's, in pixels.
interop::ScreenUniforms makeScreenUniforms(const CameraMatrices& camera, uint32_t width,
                                           uint32_t height);

/// Of an image with a texel for every 2x2 pixels; the last ones of odd sizes stand alone.
constexpr uint32_t halfSize(uint32_t pixels) { return (pixels + 1) / 2; }

}  // namespace rushlight

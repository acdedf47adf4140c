#pragma once
// A cube of radiance from six frames.

#include "renderer/frame/captured_image.h"
#include "renderer/frame/frame_input.h"
#include "renderer/lighting/environment/cube_image.h"

#include <functional>

namespace rushlight {

/// What is rendered for one face: `input`, seen a quarter turn wide from `position`. See
/// Renderer::captureEnvironment.
FrameInput captureInput(const FrameInput& input, const vec3& position, uint32_t face,
                        const CaptureDesc& desc);

/// `render` gives a frame of size x size pixels in linear radiance.
using FaceRenderer =
    std::function<Result<void>(const FrameInput& face, uint32_t size, CapturedImage& image)>;

/// Its borders are filled; what is not finite or negative is black.
Result<CubeLevel> captureCube(const FrameInput& input, const vec3& position,
                              const CaptureDesc& desc, const FaceRenderer& render);

}  // namespace rushlight

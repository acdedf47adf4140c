#pragma once

#include "renderer/renderer.h"
#include "sandbox/tool/render_setup.h"
#include "sandbox/tool/stats.h"

namespace rushlight::tool {

/// Renders one frame to its end and measures it; then fetches the picture. `times` and the report
/// of the setup's renderer describe it.
Result<CapturedImage> renderFrame(RenderSetup& setup, const FrameInput& input, uvec2 size,
                                  CaptureKind kind, const FrameOptions& options, FrameTimes& times);

}  // namespace rushlight::tool

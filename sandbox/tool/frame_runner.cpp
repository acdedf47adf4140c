#include "sandbox/tool/frame_runner.h"

#include "engine/core/check.h"
#include "sandbox/allocations.h"

#include <chrono>

namespace rushlight::tool {

Result<CapturedImage> renderFrame(RenderSetup& setup, const FrameInput& input, uvec2 size,
                                  CaptureKind kind, const FrameOptions& options,
                                  FrameTimes& times) {
    Renderer& renderer = setup.renderer();
    const uint64_t allocations = allocationCount();
    const auto start = std::chrono::steady_clock::now();
    const auto ticket = renderer.renderOffscreen(input, size.x, size.y, kind, options);
    times.allocations = allocationCount() - allocations;
    if (!ticket) return tl::unexpected(ticket.error());
    renderer.finish();
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() -
                                                              start;
    times.wallMs = elapsed.count();
    CapturedImage image;
    const bool taken = renderer.takeCapture(*ticket, true, image);
    RL_CHECK(taken, "a capture that is waited for arrives");
    return image;
}

}  // namespace rushlight::tool

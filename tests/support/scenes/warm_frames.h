#pragma once
// How many allocations frames make once the renderer is warm.

#include "tests/support/allocation_counter.h"
#include "tests/support/scenes/random_scene.h"

#include <gtest/gtest.h>

namespace rushlight {

inline constexpr uint32_t kDistinctFrames = 5;
inline constexpr uint32_t kWarmUpFrames = 3 * kDistinctFrames;
inline constexpr uint32_t kWarmFrames = 4 * kDistinctFrames;

/// Renders the scene's first frames over and over into `target`; the number of allocations after
/// three rounds: in the second, what is kept from frame to frame (cached cascades) is already
/// there, and llvmpipe compiles a last variant.
inline uint64_t allocationsOfWarmFrames(Renderer& renderer, RandomScene& scene,
                                        const FrameTarget& target) {
    const auto render = [&](uint32_t i) {
        const FrameInput input = scene.frame(i % kDistinctFrames);
        const auto rendered = renderer.render(input, target);
        if (!rendered) ADD_FAILURE() << rendered.error().text();
    };
    for (uint32_t i = 0; i < kWarmUpFrames; ++i) render(i);
    const uint64_t before = allocationsOnThisThread();
    for (uint32_t i = 0; i < kWarmFrames; ++i) render(i);
    return allocationsOnThisThread() - before;
}

/// The same for captures of both kinds into an image that is kept.
inline uint64_t allocationsOfWarmCaptures(Renderer& renderer, RandomScene& scene) {
    CapturedImage image[2];
    const auto capture = [&](uint32_t i) {
        const FrameInput input = scene.frame(i / 2 % kDistinctFrames);
        const auto ticket = renderer.renderOffscreen(
            input, 96, 64, i % 2 ? CaptureKind::hdr : CaptureKind::display);
        if (!ticket)
            ADD_FAILURE() << ticket.error().text();
        else
            EXPECT_TRUE(renderer.takeCapture(*ticket, true, image[i % 2]));
    };
    for (uint32_t i = 0; i < 2 * kWarmUpFrames; ++i) capture(i);
    const uint64_t before = allocationsOnThisThread();
    for (uint32_t i = 0; i < kWarmFrames; ++i) capture(i);
    return allocationsOnThisThread() - before;
}

}  // namespace rushlight

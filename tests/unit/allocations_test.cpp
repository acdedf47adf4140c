// "Allocates nothing per frame once warm", with no GPU.
#include "tests/support/warm_frames.h"

namespace rushlight {
namespace {

std::unique_ptr<Renderer> nullRenderer() { return std::move(Renderer::create({}).value()); }

TEST(Allocations, TheCounterCounts) {
    const uint64_t before = allocationsOnThisThread();
    std::vector<int> one(100);
    const auto two = std::make_unique<std::string>(200, 'x');
    EXPECT_EQ(allocationsOnThisThread() - before, 3u);
}

TEST(Allocations, WarmFramesMakeNone) {
    for (uint64_t seed = 0; seed < 12; ++seed) {
        const auto renderer = nullRenderer();
        RandomScene scene(*renderer, seed);
        EXPECT_EQ(allocationsOfWarmFrames(*renderer, scene, {0, 320, 200}), 0u) << "seed " << seed;
    }
}

TEST(Allocations, WarmFramesOfEveryShownImageMakeNone) {
    for (uint32_t show = 0; show < uint32_t(ShownImage::count); ++show) {
        const auto renderer = nullRenderer();
        RandomScene scene(*renderer, 2);
        scene.settings.show = ShownImage(show);
        EXPECT_EQ(allocationsOfWarmFrames(*renderer, scene, {0, 320, 200}), 0u) << toText(ShownImage(show));
    }
}

TEST(Allocations, WarmCapturesMakeNone) {
    const auto renderer = nullRenderer();
    RandomScene scene(*renderer, 1);
    EXPECT_EQ(allocationsOfWarmCaptures(*renderer, scene), 0u);
}

}  // namespace
}  // namespace rushlight

// "Allocates nothing per frame once warm", with GL. The driver's own memory comes from malloc and
// does not count.
#include "tests/support/gl/test_context.h"
#include "tests/support/scenes/warm_frames.h"

namespace rushlight {
namespace {

class AllocationsGl : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(context_.valid());
        RendererDesc desc;
        desc.loadGl = TestContext::load;
        desc.validateCommands = true;
        renderer = std::move(Renderer::create(desc).value());
    }
    TestContext context_;
    std::unique_ptr<Renderer> renderer;
};

// Seeds with and without an environment, shadows, automatic exposure.
TEST_F(AllocationsGl, WarmCapturesMakeNone) {
    for (uint64_t seed : {1, 2}) {
        RandomScene scene(*renderer, seed);
        EXPECT_EQ(allocationsOfWarmCaptures(*renderer, scene), 0u) << "seed " << seed;
    }
}

TEST_F(AllocationsGl, WarmFramesWithColouredShadowsMakeNone) {
    RandomScene scene(*renderer, 3);
    MaterialDesc desc;
    desc.transmission = 0.5f;
    const MaterialHandle glass = renderer->createMaterial(desc).value();
    for (size_t i = 0; i < scene.instances.size(); i += 3) scene.instances[i].material = glass;
    scene.settings.lightShadows = true;
    EXPECT_EQ(allocationsOfWarmCaptures(*renderer, scene), 0u);
}

TEST_F(AllocationsGl, WarmFramesWithBoundsMakeNone) {
    RandomScene scene(*renderer, 3);
    scene.settings.debugView = DebugView::bounds;
    EXPECT_EQ(allocationsOfWarmCaptures(*renderer, scene), 0u);
}

}  // namespace
}  // namespace rushlight

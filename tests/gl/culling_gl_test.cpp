// What is culled would not have been seen: pictures with and without are the same bytes.

#include "tests/support/random_scene.h"
#include "tests/support/shapes.h"
#include "tests/support/test_context.h"

#include <gtest/gtest.h>

namespace rushlight {
namespace {

class CullingGl : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(context.valid()) << "no EGL surfaceless context"; }
    void TearDown() override {
        EXPECT_TRUE(!renderer || renderer->takeDebugMessages().empty());
    }
    void open() {
        RendererDesc desc;
        desc.cacheDirectory = cache.path();  // shaders are compiled once
        desc.loadGl = TestContext::load;
        desc.debugOutput = true;
        renderer = std::move(Renderer::create(desc).value());
    }
    std::vector<uint8_t> picture(const FrameInput& input) {
        const auto ticket = renderer->renderOffscreen(input, 200, 120, CaptureKind::display);
        EXPECT_TRUE(ticket) << ticket.error().text();
        CapturedImage image;
        EXPECT_TRUE(ticket && renderer->takeCapture(*ticket, true, image));
        return image.rgba8;
    }

    TestContext context;
    TemporaryDirectory cache;
    std::unique_ptr<Renderer> renderer;
};

/// Walls and many small things behind them.
void addWalls(Renderer& renderer, RandomScene& scene, uint64_t seed) {
    Random random(seed);
    const MeshHandle wall = *renderer.createMesh(makeCube().desc("wall"));
    const MeshHandle hill = *renderer.createMesh(makeSphere(12, 16).desc("hill"));
    for (int i = 0; i < 150; ++i) {
        Instance instance;
        instance.mesh = i % 2 ? wall : hill;
        for (int c = 0; c < 3; ++c) instance.worldFromLocal[c] *= random.uniform(0.05f, 0.3f);
        instance.worldFromLocal[3] = random.vector(-12, 12);
        instance.id = 2000 + uint32_t(i);
        scene.instances.push_back(instance);
    }
    for (int i = 0; i < 9; ++i) {
        Instance instance;
        instance.mesh = i % 3 ? wall : hill;
        const vec3 size = i % 3 ? vec3(random.uniform(2, 9), random.uniform(2, 7), 0.1f) : vec3(random.uniform(1, 4));
        const mat3 turn(glm::rotate(mat4(1), random.uniform(0, 6), vec3(0, 1, 0)));
        for (int c = 0; c < 3; ++c) instance.worldFromLocal[c] = turn[c] * size[c];
        instance.worldFromLocal[3] = random.vector(-10, 10);
        instance.id = 1000 + uint32_t(i);
        scene.instances.push_back(instance);
    }
}

TEST_F(CullingGl, WhatIsHiddenWouldNotHaveBeenSeen) {
    uint32_t hidden = 0;
    for (uint64_t seed = 200; seed < 220; ++seed) {
        if (seed % 10 == 1) continue;  // environments take long and hide nothing
        open();
        RandomScene scene(*renderer, seed);
        addWalls(*renderer, scene, seed);
        scene.settings.autoExposure = false;
        for (uint32_t i = 0; i < 3; ++i) {
            scene.settings.occlusionCulling = false;
            const auto all = picture(scene.frame(i));
            EXPECT_EQ(renderer->report().culledOcclusion, 0u);
            scene.settings.occlusionCulling = true;
            EXPECT_TRUE(picture(scene.frame(i)) == all) << "seed " << seed << ", frame " << i;
            hidden += renderer->report().culledOcclusion;
        }
    }
    EXPECT_GT(hidden, 300u) << "the scenes hide too little to show anything";
}

TEST_F(CullingGl, WhatIsOutsideOfTheViewsWouldNotHaveBeenSeen) {
    uint32_t culled = 0;
    for (uint64_t seed = 300; seed < 315; ++seed) {
        if (seed % 10 == 1) continue;
        open();
        RandomScene scene(*renderer, seed);
        addWalls(*renderer, scene, seed);
        scene.settings.autoExposure = false;
        scene.settings.shadowCaching = false;
        scene.settings.smallObjectPixels = 0;
        for (uint32_t i = 0; i < 3; ++i) {
            scene.settings.frustumCulling = scene.settings.occlusionCulling = false;
            const auto all = picture(scene.frame(i));
            EXPECT_EQ(renderer->report().culledFrustum, 0u);
            const uint64_t triangles = renderer->report().triangles;
            scene.settings.frustumCulling = scene.settings.occlusionCulling = true;
            EXPECT_TRUE(picture(scene.frame(i)) == all) << "seed " << seed << ", frame " << i;
            culled += renderer->report().culledFrustum;
            EXPECT_LT(renderer->report().triangles, triangles);
        }
    }
    EXPECT_GT(culled, 1000u);
}

}  // namespace
}  // namespace rushlight

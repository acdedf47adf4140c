// What is culled would not have been seen: pictures with and without are the same bytes.

#include "tests/support/gl/test_context.h"
#include "tests/support/scenes/random_scene.h"
#include "tests/support/scenes/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace rushlight {
namespace {

class CullingGl : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(context.valid()) << "no EGL surfaceless context"; }
    void TearDown() override { EXPECT_TRUE(!renderer || renderer->takeDebugMessages().empty()); }
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
        const vec3 size = i % 3 ? vec3(random.uniform(2, 9), random.uniform(2, 7), 0.1f)
                                : vec3(random.uniform(1, 4));
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

// An update with the same vertices gives up the groups and nothing else.
TEST_F(CullingGl, GroupsThatFaceAwayWouldNotHaveBeenSeen) {
    Shape torus;
    constexpr uint32_t kAround = 24, kAcross = 14;
    for (uint32_t i = 0; i <= kAround; ++i)
        for (uint32_t k = 0; k <= kAcross; ++k) {
            const float u = 2 * kPi * float(i) / kAround, v = 2 * kPi * float(k) / kAcross;
            const float out = 1 + 0.4f * std::cos(v);
            torus.positions.push_back({out * std::cos(u), 0.4f * std::sin(v), out * std::sin(u)});
            if (i == kAround || k == kAcross) continue;
            const uint32_t a = i * (kAcross + 1) + k, b = a + kAcross + 1;
            for (uint32_t index : {a, a + 1, b, a + 1, b + 1, b}) torus.indices.push_back(index);
        }
    const Shape sphere = makeSphere(14, 21);
    uint64_t leftOut = 0;
    for (uint64_t seed = 400; seed < 407; ++seed) {
        if (seed % 10 == 1) continue;
        open();
        RandomScene scene(*renderer, seed);
        scene.settings.autoExposure = false;
        scene.settings.shadowCaching = false;
        std::array<MeshDesc, 2> descs = {torus.desc("torus"), sphere.desc("sphere")};
        std::array<MeshHandle, 2> meshes;
        for (size_t i = 0; i < 2; ++i) {
            descs[i].lods = false;
            meshes[i] = *renderer->createMesh(descs[i]);
        }
        for (size_t i = 0; i < scene.instances.size(); ++i)
            if (i % 5) scene.instances[i].mesh = meshes[i % 2];
        const auto view = [&](uint32_t i) {
            FrameInput input = scene.frame(i % 3);
            if (i < 3) return input;
            input.view.perspective = false;
            input.view.orthoHalfHeight = 9;
            input.view.farPlane = 60;
            return input;
        };
        std::array<std::vector<uint8_t>, 4> pictures;
        std::array<uint64_t, 4> triangles;
        for (uint32_t i = 0; i < 4; ++i) {
            pictures[i] = picture(view(i));
            triangles[i] = renderer->report().triangles;
        }
        for (size_t i = 0; i < 2; ++i) ASSERT_TRUE(renderer->updateMesh(meshes[i], descs[i]));
        for (uint32_t i = 0; i < 4; ++i) {
            EXPECT_TRUE(picture(view(i)) == pictures[i]) << "seed " << seed << ", frame " << i;
            leftOut += renderer->report().triangles - triangles[i];
        }
    }
    EXPECT_GT(leftOut, 30000u);
}

}  // namespace
}  // namespace rushlight

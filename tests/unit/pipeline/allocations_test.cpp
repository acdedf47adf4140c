// "Allocates nothing per frame once warm", with no GPU.
#include "tests/support/scenes/warm_frames.h"

#include "renderer/visibility/occlusion/occlusion_buffer.h"
#include "renderer/visibility/occlusion/occlusion_pick.h"
#include "tests/support/scenes/shapes.h"

#include <thread>

namespace rushlight {
namespace {

std::unique_ptr<Renderer> nullRenderer() {
    return std::move(Renderer::create({.validateCommands = true}).value());
}

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

TEST(Allocations, WarmFramesOfEveryDebugViewMakeNone) {
    for (uint32_t show = 0; show < uint32_t(DebugView::count); ++show) {
        const auto renderer = nullRenderer();
        RandomScene scene(*renderer, 2);
        scene.settings.debugView = DebugView(show);
        EXPECT_EQ(allocationsOfWarmFrames(*renderer, scene, {0, 320, 200}), 0u)
            << toText(DebugView(show));
    }
}

TEST(Allocations, WarmFramesWithShadowsOfAllLightsMakeNone) {
    uint32_t lights = 0;
    for (uint64_t seed = 0; seed < 6; ++seed) {
        const auto renderer = nullRenderer();
        RandomScene scene(*renderer, seed);
        for (PunctualLight& light : scene.lights) light.castsShadow = true;
        scene.settings.lightShadows = true;
        scene.settings.shadowAtlasSize = 1024;
        EXPECT_EQ(allocationsOfWarmFrames(*renderer, scene, {0, 320, 200}), 0u) << "seed " << seed;
        lights += renderer->report().shadowLights;
    }
    EXPECT_GT(lights, 5u);
}

TEST(Allocations, WarmFramesWithReflectionProbesMakeNone) {
    const auto renderer = nullRenderer();
    RandomScene scene(*renderer, 3);
    const std::vector<vec3> pixels(32, vec3(1));
    for (int i = 0; i < 40; ++i) {
        ReflectionProbe probe;
        probe.center = probe.position = vec3(float(i % 7) - 3, 0, float(i / 7) - 3) * 4.0f;
        probe.halfSize = vec3(3);
        if (i < 5)
            probe.environment = *renderer->createEnvironment({"light", 8, 4, pixels});
        else
            probe.environment = scene.reflectionProbes[size_t(i % 5)].environment;
        scene.reflectionProbes.push_back(probe);
    }
    EXPECT_EQ(allocationsOfWarmFrames(*renderer, scene, {0, 320, 200}), 0u);
    EXPECT_NE(renderer->printCommands().find("BindTexture 27"), std::string::npos)
        << "some are in view";
}

TEST(Allocations, WarmCapturesMakeNone) {
    const auto renderer = nullRenderer();
    RandomScene scene(*renderer, 1);
    EXPECT_EQ(allocationsOfWarmCaptures(*renderer, scene), 0u);
}

TEST(Allocations, WarmOcclusionMakesNone) {
    const Shape sphere = makeSphere(8, 12);
    const OccluderMesh mesh = makeOccluderMesh(sphere.positions, sphere.indices);
    const std::vector<OccluderCandidate> candidates(9, {100, mesh.triangleCount()});
    std::vector<uint32_t> picked;
    OcclusionBuffer buffer;
    SerialJobs jobs;
    const auto frame = [&](float turn) {
        pickOccluders(candidates, 1000, picked);
        buffer.begin(320, 200, glm::rotate(mat4(1), turn, vec3(0, 0, 1)));
        for (uint32_t i : picked) {
            mat4x3 transform(0.4f);
            transform[3] = {float(i % 3) - 1, float(i / 3) - 1, 0.5f};
            buffer.addOccluder({&mesh, transform, true});
        }
        buffer.rasterize(jobs);
        EXPECT_GT(buffer.triangleCount(), 0u);
        return buffer.isVisible({0, 0, 0.2f}, {0.1f, 0.1f, 0.1f});
    };
    frame(0);
    const uint64_t before = allocationsOnThisThread();
    for (int i = 1; i < 4; ++i) frame(float(i));
    EXPECT_EQ(allocationsOnThisThread() - before, 0u);
}

// On both threads.
TEST(Allocations, WarmFramesOfTheRenderThreadMakeNone) {
    for (uint32_t inFlight = 1; inFlight <= 3; ++inFlight) {
        RendererDesc desc;
        desc.renderThread = true;
        desc.framesInFlight = inFlight;
        const auto renderer = std::move(Renderer::create(desc).value());
        RandomScene scene(*renderer, 2);
        struct Served {
            uint32_t frames = 0;
            uint64_t before = 0, after = 0;
        } served;
        // Each of the buffers for commands must have held each of the frames.
        constexpr uint32_t kWarm = 5 * kDistinctFrames * 4, kCounted = 4 * kDistinctFrames;
        std::thread game([&] {
            uint64_t before = 0;
            for (uint32_t i = 0; i < kWarm + kCounted; ++i) {
                if (i == kWarm) before = allocationsOnThisThread();
                const FrameInput input = scene.frame(i % kDistinctFrames);
                if (!renderer->render(input, {0, 320, 200})) ADD_FAILURE();
            }
            EXPECT_EQ(allocationsOnThisThread() - before, 0u) << inFlight << " in flight";
            renderer->stopServing();
        });
        EXPECT_TRUE(renderer->serve(
            [](void* user) {
                Served& s = *static_cast<Served*>(user);
                if (++s.frames == kWarm) s.before = allocationsOnThisThread();
                s.after = allocationsOnThisThread();
            },
            &served));
        game.join();
        EXPECT_EQ(served.frames, kWarm + kCounted);
        EXPECT_EQ(served.after - served.before, 0u) << inFlight << " in flight, serving";
    }
}

}  // namespace
}  // namespace rushlight

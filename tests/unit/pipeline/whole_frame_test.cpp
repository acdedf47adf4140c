// Whole frames through the one header, with no GPU.
#include "tests/support/scenes/random_scene.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/thread_jobs.h"

#include <gtest/gtest.h>

#include <limits>

namespace rushlight {
namespace {

constexpr FrameTarget kTarget{0, 320, 200};

std::unique_ptr<Renderer> nullRenderer() {
    return std::move(Renderer::create({.validateCommands = true}).value());
}

/// The commands of the first three frames of a scene.
std::string commandsOf(uint64_t seed, JobSystem* jobs, const std::string& cache) {
    RendererDesc desc;
    desc.jobs = jobs;
    desc.validateCommands = true;
    desc.cacheDirectory = cache;
    const auto renderer = std::move(Renderer::create(desc).value());
    RandomScene scene(*renderer, seed);
    std::string text;
    for (uint32_t i = 0; i < 3; ++i) {
        const auto rendered = renderer->render(scene.frame(i), kTarget);
        EXPECT_TRUE(rendered) << rendered.error().text();
        text += renderer->printCommands();
    }
    return text;
}

TEST(WholeFrame, CommandsAreTheSameForAnyNumberOfThreadsAndAgain) {
    ThreadJobs two(2), four(4), eight(8);
    const TemporaryDirectory cache;
    size_t length = 0;
    for (uint64_t seed = 100; seed < 300; ++seed) {
        const std::string alone = commandsOf(seed, nullptr, cache.path());
        length += alone.size();
        EXPECT_TRUE(commandsOf(seed, nullptr, cache.path()) == alone) << "again, seed " << seed;
        EXPECT_TRUE(commandsOf(seed, &two, cache.path()) == alone) << "2 threads, seed " << seed;
        EXPECT_TRUE(commandsOf(seed, &four, cache.path()) == alone) << "4 threads, seed " << seed;
        EXPECT_TRUE(commandsOf(seed, &eight, cache.path()) == alone) << "8 threads, seed " << seed;
    }
    EXPECT_GT(length, 500'000u) << "the scenes are too small to differ";
}

class OneCube : public testing::Test {
protected:
    std::unique_ptr<Renderer> renderer = nullRenderer();
    MeshHandle cube = *renderer->createMesh(makeCube().desc());
    std::vector<Instance> instances;
    std::vector<DirectionalLight> suns;
    std::vector<PunctualLight> lights;
    FrameInput input;

    OneCube() {
        instances.resize(1);
        instances[0].mesh = cube;
        instances[0].worldFromLocal[3] = {0, 0, -6};
        suns.push_back({glm::normalize(vec3(-1, -2, -1)), vec3(2), true});
    }
    Result<void> render(const FrameTarget& target = kTarget) {
        input.instances = instances;
        input.lighting.directional = suns;
        input.lighting.punctual = lights;
        return renderer->render(input, target);
    }
    const PassReport* pass(std::string_view name) const {
        for (const PassReport& p : renderer->report().passes)
            if (p.name == name) return &p;
        return nullptr;
    }
};

TEST_F(OneCube, TheReportCounts) {
    instances.resize(5, instances[0]);
    instances[1].worldFromLocal[3].z = 60;  // behind the camera
    instances[2].mesh = {};
    instances[3].worldFromLocal[0].x = std::numeric_limits<float>::quiet_NaN();
    lights.resize(2);
    lights[0].position = {0, 2, -6};
    lights[1].position = {0, 0, 500};
    lights[0].range = lights[1].range = 5;
    ASSERT_TRUE(render());
    const FrameReport& r = renderer->report();
    EXPECT_EQ(r.instances, 5u);
    EXPECT_EQ(r.visible, 2u);
    EXPECT_EQ(r.culledFrustum, 1u);
    EXPECT_EQ(r.rejected, 2u);
    EXPECT_EQ(r.lights, 3u);
    EXPECT_EQ(r.lightsVisible, 2u);
    EXPECT_EQ(r.shadowViewsDrawn, 4u);
    EXPECT_GT(r.uploadedBytes, 0u);
    ASSERT_NE(pass("gbuffer"), nullptr);
    EXPECT_EQ(pass("gbuffer")->draws, 1u) << "two instances of one mesh";
    EXPECT_EQ(pass("gbuffer")->triangles, 24u);
    uint64_t triangles = 0, draws = 0;
    for (const PassReport& p : r.passes) triangles += p.triangles, draws += p.draws;
    EXPECT_EQ(r.triangles, triangles);
    EXPECT_EQ(r.draws, draws);
    EXPECT_LE(pass("gbuffer")->bytesPerPixel, 16u);
}

TEST_F(OneCube, FramesAreNumbered) {
    ASSERT_TRUE(render());
    const uint64_t first = renderer->report().frameNumber;
    ASSERT_TRUE(render());
    EXPECT_EQ(renderer->report().frameNumber, first + 1);
}

TEST_F(OneCube, UnchangedShadowsAreKeptAndMovedCastersDrawn) {
    ASSERT_TRUE(render());
    EXPECT_EQ(renderer->report().shadowViewsDrawn, 4u);
    ASSERT_TRUE(render());
    EXPECT_EQ(renderer->report().shadowViewsDrawn, 0u);
    EXPECT_EQ(renderer->report().shadowViewsCached, 4u);
    instances[0].worldFromLocal[3].x += 0.01f;
    ASSERT_TRUE(render());
    EXPECT_GT(renderer->report().shadowViewsDrawn, 0u);
    input.settings.shadowCaching = false;
    ASSERT_TRUE(render());
    EXPECT_EQ(renderer->report().shadowViewsDrawn, 4u);
}

TEST_F(OneCube, NothingToDrawIsAFrameToo) {
    instances.clear();
    suns.clear();
    ASSERT_TRUE(render());
    EXPECT_EQ(renderer->report().visible, 0u);
    EXPECT_EQ(pass("gbuffer")->triangles, 0u);
    EXPECT_TRUE(render({0, 1, 1}));
}

TEST_F(OneCube, AMinimisedWindowIsNoError) {
    ASSERT_TRUE(render());
    const uint64_t last = renderer->report().frameNumber;
    for (const FrameTarget& target :
         {FrameTarget{0, 0, 0}, FrameTarget{0, 0, 10}, FrameTarget{0, 10, 0}})
        EXPECT_TRUE(render(target));
    EXPECT_EQ(renderer->report().frameNumber, last) << "nothing was built";
    EXPECT_FALSE(renderer->renderOffscreen(input, 0, 10, CaptureKind::display))
        << "there would be no picture";
    ASSERT_TRUE(render());
    EXPECT_EQ(renderer->report().frameNumber, last + 1);
}

TEST_F(OneCube, DestroyingWhatIsInUseIsSafe) {
    const std::vector<uint8_t> pixels(16, 200);
    const ImageHandle image = *renderer->createImage({"image", 2, 2, true, pixels});
    MaterialDesc desc;
    desc.baseColorTexture.image = image;
    instances[0].material = *renderer->createMaterial(desc);
    ASSERT_TRUE(render());
    renderer->destroy(image);
    EXPECT_TRUE(render()) << "a material without its image";
    EXPECT_EQ(renderer->report().visible, 1u);
    renderer->destroy(instances[0].material);
    EXPECT_TRUE(render());
    EXPECT_EQ(renderer->report().rejected, 1u);
    instances[0].material = {};
    renderer->destroy(cube);
    EXPECT_TRUE(render());
    EXPECT_EQ(renderer->report().rejected, 1u);
}

TEST_F(OneCube, CapturesHaveTheirSizeAndComeOnce) {
    input.instances = instances;
    const auto ticket = renderer->renderOffscreen(input, 33, 17, CaptureKind::display);
    const auto hdr = renderer->renderOffscreen(input, 40, 20, CaptureKind::hdr);
    ASSERT_TRUE(ticket && hdr);
    CapturedImage image;
    ASSERT_TRUE(renderer->takeCapture(*hdr, true, image));
    EXPECT_EQ(image.rgba32f.size(), 40u * 20 * 4);
    ASSERT_TRUE(renderer->takeCapture(*ticket, true, image));
    EXPECT_EQ(image.width, 33u);
    EXPECT_EQ(image.height, 17u);
    EXPECT_EQ(image.rgba8.size(), 33u * 17 * 4);
    EXPECT_FALSE(renderer->takeCapture(*ticket, true, image)) << "taken already";
    EXPECT_FALSE(renderer->takeCapture({}, true, image));
}

TEST_F(OneCube, WrongInputIsAnErrorAndTheNextFrameIsFine) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto refused = [&](auto&& spoil, const FrameTarget& target = kTarget) {
        const FrameInput good = input;
        const auto goodSuns = suns;
        spoil();
        const auto rendered = render(target);
        input = good;
        suns = goodSuns;
        lights.clear();
        EXPECT_TRUE(render());
        return !rendered && rendered.error().kind == ErrorKind::wrongUse &&
               rendered.error().message.size() > 10;
    };
    const auto nothing = [] {};
    EXPECT_FALSE(refused(nothing));
    EXPECT_TRUE(refused(nothing, {0, 16385, 10}));
    EXPECT_TRUE(refused([&] { input.view.verticalFov = 0; }));
    EXPECT_TRUE(refused([&] { input.view.viewFromWorld[0][0] = nan; }));
    EXPECT_TRUE(refused([&] { suns.resize(5, suns[0]); }));
    EXPECT_TRUE(refused([&] { suns[0].direction = vec3(0); }));
    EXPECT_TRUE(refused([&] { suns[0].illuminance.y = nan; }));
    EXPECT_TRUE(refused([&] { lights.resize(4097); }));
    EXPECT_TRUE(refused([&] { lights.resize(1), lights[0].position.x = nan; }));
    EXPECT_TRUE(refused([&] { lights.resize(1), lights[0].outerConeAngle = nan; }));
    EXPECT_TRUE(refused([&] { lights.resize(1), lights[0].innerConeAngle = nan; }));
    EXPECT_TRUE(refused([&] { input.settings.shadowCascades = 0; }));
    EXPECT_TRUE(refused([&] { input.settings.shadowCascades = 5; }));
    EXPECT_TRUE(refused([&] { input.settings.shadowResolution = 1 << 20; }));
    EXPECT_TRUE(refused([&] { input.settings.shadowDistance = nan; }));
    EXPECT_TRUE(refused([&] { input.settings.exposureScale = nan; }));
    EXPECT_TRUE(refused([&] { input.settings.exposureValue = nan; }));
    EXPECT_TRUE(refused([&] { input.settings.bloomStrength = nan; }));
    EXPECT_TRUE(refused([&] { input.settings.deltaTime = nan; }));
    EXPECT_TRUE(refused([&] { input.lighting.ambientSky.x = nan; }));
    EXPECT_TRUE(refused([&] { input.lighting.ambientGround.z = nan; }));
    EXPECT_TRUE(refused([&] { input.lighting.backgroundColor.x = nan; }));
    EXPECT_TRUE(refused([&] { input.lighting.environmentRotation = nan; }));
    EXPECT_TRUE(refused([&] { input.lighting.environmentIntensity = nan; }));
    EXPECT_TRUE(refused([&] { input.lighting.environment = {1u << 20 | 77}; }));
}

TEST_F(OneCube, BadOverlaysAreRefused) {
    const std::vector<uint8_t> pixels(16, 200);
    const ImageHandle image = *renderer->createImage({"font", 2, 2, false, pixels});
    const std::vector<OverlayVertex> corners(3, OverlayVertex{{1, 1}, {0, 0}, ~0u});
    const std::vector<uint32_t> beyond = {0, 1, 3};
    const OverlayBatch batch{0, 3, {0, 0}, {9, 9}}, tooLong{0, 6, {0, 0}, {9, 9}};
    input.overlay = {corners, beyond, {&batch, 1}, image};
    EXPECT_FALSE(render());
    const std::vector<uint32_t> good = {0, 1, 2};
    input.overlay = {corners, good, {&tooLong, 1}, image};
    EXPECT_FALSE(render());
    input.overlay = {corners, good, {&batch, 1}, image};
    EXPECT_TRUE(render());
    EXPECT_EQ(pass("overlay")->draws, 1u);
    renderer->destroy(image);
    EXPECT_FALSE(render()) << "its image is a stale handle";
}

}  // namespace
}  // namespace rushlight

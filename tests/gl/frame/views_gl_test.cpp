// Views that are rendered in one step do not disturb each other, and one whose frame fails
// remembers what it remembered before.
#include "tests/support/gl/test_context.h"
#include "tests/support/random.h"
#include "tests/support/scenes/random_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>

namespace rushlight {
namespace {

constexpr uint32_t kSteps = 8;

struct Step {
    std::vector<uint8_t> pixels;
    std::vector<uint64_t> hashes;  ///< of all passes
    bool operator==(const Step&) const = default;
};

/// A world in which something moves at each step, as two cameras see it: of different sizes,
/// exposures, shadows and ways, one with a picture at every step and one at every second.
class Stage {
public:
    explicit Stage(GlLoadFunction load) {
        RendererDesc desc;
        desc.loadGl = load;
        desc.validateCommands = true;
        renderer = std::move(Renderer::create(desc).value());
        scene = std::make_unique<RandomScene>(*renderer, 12);
        world = renderer->createWorld();
        moving.assign(scene->instances.begin(), scene->instances.begin() + 40);
        for (Instance& instance : moving) instance.flags &= ~uint32_t(kInstanceMoving);
        handles.resize(moving.size());
        EXPECT_TRUE(renderer->addInstances(world, moving, handles));
        views = {ViewHandle{}, renderer->createView()};
    }
    void move(uint32_t step) {
        Random random(step + 1);
        for (Instance& instance : moving)
            if (random.below(3) == 0) instance.worldFromLocal[3] += random.vector(-0.2f, 0.2f);
        EXPECT_TRUE(renderer->updateInstances(world, handles, moving));
    }
    FrameInput input(uint32_t which, uint32_t step) {
        FrameInput frame = scene->frame(which ? 7 * step : step);
        frame.view.state = views[which];
        frame.world = world;
        frame.settings.autoExposure = true;
        frame.settings.deltaTime = 0.1f;
        frame.settings.lightShadows = true;
        frame.settings.shadowAtlasSize = 1024;
        frame.settings.shadowTileSize = 256;
        if (which) frame.settings.shadowCascades = 2;
        for (PunctualLight& light : scene->lights) light.castsShadow = true;
        return frame;
    }
    Step render(uint32_t which, uint32_t step) {
        const uint32_t width = which ? 96 : 160, height = which ? 128 : 90;
        const auto ticket = renderer->renderOffscreen(input(which, step), width, height,
                                                      CaptureKind::display, {.hashPasses = true});
        CapturedImage image;
        EXPECT_TRUE(ticket && renderer->takeCapture(*ticket, true, image));
        Step result{image.rgba8, {}};
        for (const PassReport& pass : renderer->report().passes)
            result.hashes.insert(result.hashes.end(), pass.hashes.begin(), pass.hashes.end());
        return result;
    }

    std::unique_ptr<Renderer> renderer;
    std::unique_ptr<RandomScene> scene;
    WorldHandle world;
    std::vector<Instance> moving;
    std::vector<InstanceHandle> handles;
    std::array<ViewHandle, 2> views;
};

bool shows(uint32_t which, uint32_t step) { return which == 0 || step % 2 == 0; }

std::vector<Step> alone(GlLoadFunction load, uint32_t which) {
    Stage stage(load);
    std::vector<Step> steps;
    for (uint32_t step = 0; step < kSteps; ++step) {
        stage.move(step);
        if (shows(which, step)) steps.push_back(stage.render(which, step));
    }
    return steps;
}

class Views : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(context.valid()) << "no surfaceless EGL context with OpenGL 4.5";
    }
    TestContext context;
};

TEST_F(Views, InOneStepGiveTheBytesOfEachAlone) {
    const std::array expected = {alone(&TestContext::load, 0), alone(&TestContext::load, 1)};
    ASSERT_NE(expected[0].back(), expected[0].front());
    Stage stage(&TestContext::load);
    EnvironmentHandle captured;
    std::array<std::vector<Step>, 2> steps;
    for (uint32_t step = 0; step < kSteps; ++step) {
        stage.move(step);
        for (uint32_t which : {0u, 1u})
            if (shows(which, step)) steps[which].push_back(stage.render(which, step));
        if (step % 3 == 0) {
            const FrameInput around = stage.input(0, step);
            const auto made = stage.renderer->captureEnvironment(around, vec3(step, 1, 0),
                                                                 {.size = 16});
            ASSERT_TRUE(made) << made.error().text();
            stage.renderer->destroy(*made);
        }
    }
    for (uint32_t which : {0u, 1u}) {
        ASSERT_EQ(steps[which].size(), expected[which].size());
        for (size_t i = 0; i < expected[which].size(); ++i)
            EXPECT_EQ(steps[which][i], expected[which][i]) << "view " << which << ", frame " << i;
    }
}

TEST_F(Views, AFrameThatFailsLeavesItsViewAsItWas) {
    const std::vector<Step> expected = alone(&TestContext::load, 0);
    Stage stage(&TestContext::load);
    std::vector<Step> steps;
    for (uint32_t step = 0; step < kSteps; ++step) {
        stage.move(step);
        FrameInput broken = stage.input(0, step + 20);
        OverlayBatch batch;
        batch.indexCount = 1 << 20;  // found out after everything else was planned
        broken.overlay.batches = {&batch, 1};
        EXPECT_FALSE(stage.renderer->renderOffscreen(broken, 160, 90, CaptureKind::display));
        steps.push_back(stage.render(0, step));
    }
    for (size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(steps[i], expected[i]) << i;
}

// What a pass does not declare, it may not depend on.
TEST_F(Views, AnyOrderThatThePlanAllowsGivesTheSameBytes) {
    constexpr uint32_t kSeeds = 100;
    const auto render = [](Stage& stage, uint64_t seed) {
        FrameInput input = stage.input(0, 1);
        input.settings.cut = true;
        input.settings.shadowCaching = false;
        input.settings.reflections = true;
        input.settings.ambientOcclusion = AmbientOcclusion::low;
        input.lighting.fog.density = 0.02f;
        const auto ticket = stage.renderer->renderOffscreen(
            input, 64, 36, CaptureKind::display, {.hashPasses = true, .passOrderSeed = seed});
        CapturedImage image;
        EXPECT_TRUE(ticket && stage.renderer->takeCapture(*ticket, true, image));
        std::map<std::string, std::vector<uint64_t>> hashes;
        std::string order;
        for (const PassReport& pass : stage.renderer->report().passes) {
            hashes[pass.name] = pass.hashes;
            order += std::string(pass.name) + " ";
        }
        return std::tuple(image.rgba8, hashes, order);
    };
    Stage stage(&TestContext::load);
    const auto [pixels, hashes, order] = render(stage, 0);
    std::set<std::string> orders;
    for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const auto [otherPixels, otherHashes, otherOrder] = render(stage, seed);
        ASSERT_EQ(otherHashes, hashes) << otherOrder;
        ASSERT_EQ(otherPixels, pixels) << otherOrder;
        orders.insert(otherOrder);
    }
    EXPECT_GT(orders.size(), kSeeds / 2);
}

// An off-centre frustum is a part of a larger picture: the same pixels, whatever lights them.
TEST_F(Views, AnOffCentreOneIsAPartOfALargerPicture) {
    constexpr uint32_t kWidth = 192, kHeight = 96;
    Stage stage(&TestContext::load);
    const uint8_t red[4] = {255, 0, 0, 255};
    DecalMaterialDesc paint;
    paint.label = "red";
    paint.baseColor = {"red", 1, 1, true, red};
    Decal decal;
    decal.material = stage.renderer->createDecalMaterial(paint).value();
    decal.worldFromDecal = mat4x3(6.0f);
    for (uint32_t step : {0u, 3u}) {
        FrameInput input = stage.input(0, step);
        input.decals = {&decal, 1};
        input.lighting.fog.density = 0.01f;
        input.settings.cut = true;
        input.settings.autoExposure = input.settings.bloom = input.settings.dither = false;
        input.settings.antiAliasing = AntiAliasing::off;
        input.settings.smallObjectPixels = 0;
        input.overlay = {};
        input.settings.shadows = false;  // cascades and tiles are fitted to what is seen
        const auto render = [&](const vec4& frustum, uint32_t width, uint32_t height) {
            input.view.frustum = frustum;
            const auto ticket = stage.renderer->renderOffscreen(input, width, height,
                                                                CaptureKind::display);
            CapturedImage image;
            EXPECT_TRUE(ticket && stage.renderer->takeCapture(*ticket, true, image));
            return image;
        };
        const CapturedImage whole = render({-1, 1, -0.5f, 0.5f}, kWidth, kHeight);
        // The right third, the lower half.
        const CapturedImage part = render({1.0f / 3, 1, -0.5f, 0}, kWidth / 3, kHeight / 2);
        uint32_t different = 0, colors = 0;
        for (uint32_t y = 0; y < part.height; ++y)
            for (uint32_t x = 0; x < part.width; ++x) {
                const uint8_t* a = &part.rgba8[(y * part.width + x) * 4];
                const uint8_t* b =
                    &whole.rgba8[((y + kHeight / 2) * kWidth + x + kWidth * 2 / 3) * 4];
                int most = 0;
                for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(int(a[c]) - int(b[c])));
                different += most > 3;
                colors += a[0] != part.rgba8[0];
            }
        EXPECT_LT(different, part.width * part.height / 50) << "step " << step;
        EXPECT_GT(colors, part.width * part.height / 4) << "there is little to be seen";
    }
}

TEST_F(Views, AStaleOneIsAnError) {
    Stage stage(&TestContext::load);
    stage.renderer->destroy(stage.views[1]);
    const auto ticket = stage.renderer->renderOffscreen(stage.input(1, 0), 16, 16,
                                                        CaptureKind::display);
    ASSERT_FALSE(ticket);
    EXPECT_EQ(ticket.error().kind, ErrorKind::wrongUse);
    EXPECT_NE(ticket.error().text().find("stale"), std::string::npos);
}

}  // namespace
}  // namespace rushlight

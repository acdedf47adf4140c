// Reflection probes in the picture: a room whose walls are known is mirrored where they stand.

#include "renderer/lighting/environment/cube_image.h"
#include "tests/support/scenes/screen_frames.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rushlight {
namespace {

constexpr vec3 kLow{-2, 0, -3}, kHigh{2, 2.6f, 3};  // of the room
constexpr vec3 kColors[6] = {{1, 0.1f, 0.1f}, {0.1f, 1, 0.1f}, {0.1f, 0.1f, 1},
                             {1, 1, 0.1f},    {0.1f, 1, 1},    {1, 0.1f, 1}};  // by axis, low first

class ReflectionProbesGl : public ScreenFrames {
protected:
    void SetUp() override {
        ScreenFrames::SetUp();
        input.settings.bloom = false;
        input.settings.shadows = false;
        input.view.verticalFov = 1.1f;
        look({-1.2f, 1.6f, 2.6f}, {0.3f, 0.3f, -0.8f});
        probe.position = {-0.6f, 1.3f, 0.8f};
        probe.center = (kLow + kHigh) * 0.5f;
        probe.halfSize = (kHigh - kLow) * 0.5f;
    }
    MaterialHandle material(const vec3& color, float metallic, float roughness, bool unlit = false,
                            AlphaMode mode = AlphaMode::opaque) {
        MaterialDesc desc;
        desc.baseColor = vec4(color, 1);
        desc.metallic = metallic;
        desc.roughness = roughness;
        desc.unlit = unlit;
        desc.alphaMode = mode;
        return *renderer->createMaterial(desc);
    }
    /// Six walls that shine of themselves, each in a colour of its own.
    void buildRoom() {
        for (int axis = 0; axis < 3; ++axis)
            for (int side = 0; side < 2; ++side) {
                vec3 low = kLow - 0.1f, high = kHigh + 0.1f;
                (side ? low : high)[axis] = side ? kHigh[axis] : kLow[axis];
                scene->addBox(low, high, material(kColors[2 * axis + side], 0, 1, true));
            }
    }
    EnvironmentHandle capture(CaptureDesc desc = {.size = 128}) {
        input.instances = scene->instances();
        const auto made = renderer->captureEnvironment(input, probe.position, desc);
        EXPECT_TRUE(made) << made.error().text();
        return made ? *made : EnvironmentHandle{};
    }
    EnvironmentHandle constant(const vec3& radiance) {
        const std::vector<vec3> pixels(32, radiance);
        return *renderer->createEnvironment({"constant", 8, 4, pixels});
    }
    void show(std::span<const ReflectionProbe> probes) { input.lighting.reflectionProbes = probes; }
    CapturedImage picture() { return render(CaptureKind::hdr); }
    static vec3 at(const CapturedImage& image, uint32_t x, uint32_t y) {
        const float* p = &image.rgba32f[(size_t(y) * image.width + x) * 4];
        return {p[0], p[1], p[2]};
    }
    /// The share of the pixels showing objects from `first` on that have the colour of the wall
    /// which a ray mirrored there reaches. Others of these objects are not to be hit.
    float shareRight(const CapturedImage& image, uint32_t first) {
        const CameraMatrices view = camera();
        uint32_t right = 0, all = 0;
        for (uint32_t y = 0; y < kHeight; ++y)
            for (uint32_t x = 0; x < kWidth; ++x) {
                const auto seen = seenAt(view, x, y);
                if (!seen || seen->object < first) continue;
                const vec3 r = glm::reflect(-seen->view, seen->normal);
                const auto hit = scene->cast(seen->position, r, 1e-3f);
                if (!hit || hit->object >= first) continue;
                const vec3 difference = at(image, x, y) - kColors[hit->object];
                ++all;
                right += glm::length(difference) < 0.1f;
            }
        EXPECT_GT(all, 2000u);
        return float(right) / float(std::max(all, 1u));
    }

    ReflectionProbe probe;
};

float largestDifference(const CapturedImage& a, const CapturedImage& b) {
    float largest = 0;
    for (size_t i = 0; i < a.rgba32f.size(); ++i)
        largest = std::max(largest, std::abs(a.rgba32f[i] - b.rgba32f[i]));
    return largest;
}

TEST_F(ReflectionProbesGl, ACaptureSeesEachWallWhereItIs) {
    buildRoom();
    const EnvironmentHandle environment = capture();
    // Shown from where it was captured, as the background, it is what the room itself shows.
    for (const vec3 target : {vec3(1, 0.3f, 0.2f), vec3(-1, -0.8f, 0.5f), vec3(0.3f, 0.7f, -1)}) {
        look(probe.position, probe.position + target);
        const CapturedImage room = picture();
        input.instances = {};
        input.lighting.environment = environment;
        input.lighting.background = Background::environment;
        const auto ticket = renderer->renderOffscreen(input, kWidth, kHeight, CaptureKind::hdr);
        CapturedImage captured;
        ASSERT_TRUE(ticket && renderer->takeCapture(*ticket, true, captured));
        input.lighting.environment = {};
        uint32_t wrong = 0;
        for (uint32_t y = 0; y < kHeight; ++y)
            for (uint32_t x = 0; x < kWidth; ++x)
                wrong += glm::length(at(room, x, y) - at(captured, x, y)) > 0.05f;
        EXPECT_LT(wrong, kWidth * kHeight * 3 / 100);
    }
}

TEST_F(ReflectionProbesGl, FlatMirrorsShowTheWallsWhereTheyStand) {
    buildRoom();
    probe.environment = capture();
    scene->addBox({-1.5f, -0.05f, -2.5f}, {1.5f, 0.002f, 2.2f}, material(vec3(1), 1, 0));
    show(std::span(&probe, 1));
    EXPECT_GT(shareRight(picture(), 6), 0.97f);
    probe.halfSize = vec3(1e4f);  // as if the walls were far away: no correction
    EXPECT_LT(shareRight(picture(), 6), 0.75f);
}

TEST_F(ReflectionProbesGl, BallsMirrorTheRoomAsDeferredAndAsForwardSurfaces) {
    for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::blend})
        for (const bool turned : {false, true}) {
            scene = std::make_unique<RayScene>(*renderer);
            probe.rotation = turned ? glm::angleAxis(kPi / 2, vec3(0, 1, 0)) : quat(1, 0, 0, 0);
            const vec3 half = (kHigh - kLow) * 0.5f;
            probe.halfSize = turned ? vec3(half.z, half.y, half.x) : half;  // the same walls
            buildRoom();
            probe.environment = capture();
            scene->addBall({0.5f, 0.8f, -0.5f}, 0.75f, material(vec3(1), 1, 0, false, mode));
            show(std::span(&probe, 1));
            EXPECT_GT(shareRight(picture(), 6), 0.95f) << int(mode) << turned;
            show({});
        }
}

TEST_F(ReflectionProbesGl, ADistantProbeIsTheEnvironmentItself) {
    std::vector<vec3> pixels(64 * 32);
    for (uint32_t i = 0; i < pixels.size(); ++i) {
        const float x = float(i % 64) / 64, y = float(i / 64) / 32;
        pixels[i] = vec3(1 + 0.8f * std::sin(2 * kPi * x), 1.2f - y,
                         0.5f + 0.4f * std::cos(2 * kPi * x));
    }
    const EnvironmentHandle environment = *renderer->createEnvironment({"waves", 64, 32, pixels});
    look({0, 1, 5}, {0, 0.5f, 0});
    scene->addBall({-1.6f, 0.5f, 0}, 0.7f, material(vec3(0.8f), 0, 0.3f));
    scene->addBall({0, 0.5f, 0}, 0.7f, material(vec3(0.9f, 0.7f, 0.5f), 1, 0.5f));
    scene->addBall({1.6f, 0.5f, 0}, 0.7f, material(vec3(0.6f), 0, 1));
    input.lighting.environment = environment;
    const CapturedImage global = picture();
    input.lighting.environment = constant(vec3(7, 0, 0));  // what the probe must hide
    probe = {.environment = environment, .halfSize = vec3(1e5f)};
    show(std::span(&probe, 1));
    EXPECT_LT(largestDifference(global, picture()), 0.01f);
    input.lighting.environment = {};  // and without any
    EXPECT_LT(largestDifference(global, picture()), 0.01f);
    probe.intensity = 2;
    EXPECT_GT(largestDifference(global, picture()), 0.5f);
}

TEST_F(ReflectionProbesGl, TwoRoomsDoNotLeakAndBlendsHaveNoEdge) {
    const std::array colors = {vec3(1, 0, 0), vec3(0, 0, 1)};
    std::vector<ReflectionProbe> probes;
    for (const vec3& color : colors) {
        const float x = probes.empty() ? -1.1f : 1.1f;  // a wall of 0.2 m between
        probes.push_back({.position = {x, 0, 0},
                          .environment = constant(color),
                          .center = {x, 0, 0},
                          .halfSize = {1, 1, 1}});
    }
    show(probes);
    input.lighting.environment = constant(vec3(0, 1, 0));
    look({0, 4, 0.01f}, {0, 0, 0});
    scene->addBox({-2, -0.1f, -0.9f}, {2, 0, 0.9f}, material(vec3(1), 0, 0.8f));
    const auto check = [&](const CapturedImage& image, float blend) {
        const CameraMatrices view = camera();
        vec3 last(0);
        float lastX = -9;
        for (uint32_t x = 0; x < kWidth; ++x) {
            const auto seen = seenAt(view, x, kHeight / 2);
            if (!seen || std::abs(seen->position.x) > (blend > 0 ? 1.6f : 1.95f) ||
                seen->normal.y < 0.9f)
                continue;
            const vec3 c = at(image, x, kHeight / 2);
            const float side = std::abs(seen->position.x);
            if (side > 0.1f + blend) {
                EXPECT_LT(seen->position.x < 0 ? c.b : c.r, 1e-3f)
                    << "the other room, at " << seen->position.x;
                EXPECT_LT(c.g, 1e-3f) << "the surroundings, at " << seen->position.x;
            }
            if (blend > 0 && lastX > -3) {
                EXPECT_LT(glm::length(c - last), 3 * std::abs(seen->position.x - lastX) / blend)
                    << seen->position.x;
            }
            last = c;
            lastX = seen->position.x;
        }
    };
    check(picture(), 0);
    for (ReflectionProbe& p : probes)
        p.center.x *= 0.8f, p.halfSize.x = 1.3f, p.blend.x = 0.5f;  // they overlap
    check(picture(), 0.52f);
}

TEST_F(ReflectionProbesGl, TheSameCaptureGivesTheSameBytesAndANewOneOtherLight) {
    buildRoom();
    scene->addBox({-1.9f, 0, -2.9f}, {-1.2f, 0.9f, -2}, material(vec3(0.8f), 0, 0.9f));
    const PunctualLight lamp{.position = {0, 2.3f, 0}, .intensity = vec3(20)};
    input.lighting.punctual = std::span(&lamp, 1);
    std::vector<float> first;
    const uint32_t mirrors = uint32_t(scene->instances().size());
    for (int run = 0; run < 2; ++run) {
        open(nullptr);
        buildRoom();
        scene->addBox({-1.9f, 0, -2.9f}, {-1.2f, 0.9f, -2}, material(vec3(0.8f), 0, 0.9f));
        input.instances = scene->instances();
        probe.environment = capture();
        scene->addBall({0.5f, 0.8f, -0.5f}, 0.75f, material(vec3(1), 1, 0.2f));
        show(std::span(&probe, 1));
        const CapturedImage image = picture();
        if (run == 0)
            first = image.rgba32f;
        else
            EXPECT_EQ(first, image.rgba32f);
        show({});
    }
    ASSERT_EQ(scene->instances().size(), mirrors + 1);

    // The ball alone shows what the probe holds.
    const auto ballWith = [&] {
        show(std::span(&probe, 1));
        input.lighting.punctual = {};
        const CapturedImage image = picture();
        show({});
        return image;
    };
    const CapturedImage before = ballWith();
    const PunctualLight brighter{.position = {0, 2.3f, 0}, .intensity = vec3(200)};
    input.lighting.punctual = std::span(&brighter, 1);
    input.instances = scene->instances().first(mirrors);
    const auto done = renderer->recaptureEnvironment(probe.environment, input, probe.position,
                                                     {.size = 128});
    ASSERT_TRUE(done) << done.error().text();
    const CapturedImage after = ballWith();
    EXPECT_GT(largestDifference(before, after), 1);
}

TEST_F(ReflectionProbesGl, ReflectionsOfTheScreenFallBackToThem) {
    buildRoom();
    probe.environment = capture();
    scene->addBall({0.5f, 0.8f, -0.5f}, 0.75f, material(vec3(1), 1, 0));
    show(std::span(&probe, 1));
    input.settings.reflections = true;
    input.settings.ambientOcclusion = AmbientOcclusion::low;
    // What the screen shows of the walls and what the probe holds of them are the same, so is their
    // mixture.
    EXPECT_GT(shareRight(picture(), 6), 0.9f);
    EXPECT_TRUE(hasPass("reflections"));
}

TEST_F(ReflectionProbesGl, FramesWithoutThemAreWhatTheyWere) {
    buildRoom();
    scene->addBall({0.5f, 0.8f, -0.5f}, 0.75f, material(vec3(1), 1, 0));
    const CapturedImage never = picture();
    const auto printed = [&] {
        const std::string all = renderer->printCommands();
        return all.substr(0, all.find("Readback"));  // its ticket is another one
    };
    const std::string commands = printed();
    probe.environment = constant(vec3(1));
    show(std::span(&probe, 1));
    picture();
    EXPECT_NE(commands, printed());
    probe.center.z = probe.position.z = 1e6f;  // none in view
    picture();
    show({});
    EXPECT_EQ(never.rgba32f, picture().rgba32f);
    EXPECT_EQ(commands, printed());
}

}  // namespace
}  // namespace rushlight

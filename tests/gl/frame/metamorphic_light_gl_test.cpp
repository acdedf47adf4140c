// Changes of the input that change the picture by rounding alone. Bounds and what they rest on:
// - sums in another order: a radiance is a sum of a few dozen floats, kept as a half; it may end
// one place beside.
// - another place in the world: rasterising, depths and shadow maps round anew, which shows at
// edges.

#include "tests/support/scenes/metamorphic.h"

#include <algorithm>

namespace rushlight {
namespace {

constexpr uint64_t kSeeds[] = {1, 2, 3, 4};

/// Those that are drawn without shadows too, by programs of their own.
constexpr uint64_t kUnshadowed[] = {3, 4};
bool isDrawn(uint64_t seed, bool shadows) {
    return shadows || std::ranges::find(kUnshadowed, seed) != std::end(kUnshadowed);
}

TEST_F(Metamorphic, TheOrderOfLights) {
    uint32_t shadowed = 0;
    for (const uint64_t seed : kSeeds) {
        SCOPED_TRACE(seed);
        VariedScene scene(renderer(), seed);
        for (size_t i = 0; i < scene.lights.size(); ++i) scene.lights[i].castsShadow = i % 3 != 1;
        const Pictures before = picture(scene.frame(0));
        shadowed += renderer().report().shadowLights;
        // Squares of the atlas are given by the lights' order.
        std::ranges::reverse(scene.lights);
        std::ranges::reverse(scene.areas);
        expectNear(before, picture(scene.frame(0)), 0.002, 1e-4);
    }
    EXPECT_GT(shadowed, 6u);
}

TEST_F(Metamorphic, ALightOrTwoOfHalfItsIntensity) {
    uint32_t halved = 0;
    for (const uint64_t seed : kSeeds) {
        SCOPED_TRACE(seed);
        VariedScene scene(renderer(), seed);
        const Pictures before = picture(scene.frame(0));
        const size_t count = scene.lights.size();
        for (size_t i = 0; i < count; ++i) {
            if (scene.lights[i].castsShadow)
                continue;  // another's square in the atlas is another texel grid
            scene.lights[i].intensity *= 0.5f;
            scene.lights.push_back(scene.lights[i]);
            ++halved;
        }
        for (size_t i = 0; i < scene.suns.size(); ++i)
            if (!scene.suns[i].castsShadow && scene.suns.size() < kMaxDirectionalLights) {
                scene.suns[i].illuminance *= 0.5f;
                scene.suns.push_back(scene.suns[i]);
                break;
            }
        expectNear(before, picture(scene.frame(0)), 0.002, 1e-4);
    }
    EXPECT_GT(halved, 12u);
}

// A power of two loses nothing, but where a half float is nearly zero (fog's first slices): one
// place, one of 255 at a few pixels. Bloom is off: it weighs bright pixels down by what they are,
// before exposure. What glows is left out: the G-buffer's emissive has steps of its own.
TEST_F(Metamorphic, MoreLightUnderAShorterExposure) {
    constexpr float kFactor = 8;
    for (const uint64_t seed : kSeeds) {
        SCOPED_TRACE(seed);
        VariedScene scene(renderer(), seed, {.glows = false});
        scene.settings.bloom = false;
        const Pictures before = picture(scene.frame(0));
        for (DirectionalLight& sun : scene.suns) sun.illuminance *= kFactor;
        for (PunctualLight& light : scene.lights) light.intensity *= kFactor;
        for (AreaLight& area : scene.areas) area.luminance *= kFactor;
        scene.settings.exposureScale /= kFactor;
        FrameInput input = scene.frame(0);
        for (vec3* light : {&input.lighting.ambientSky, &input.lighting.ambientGround,
                            &input.lighting.backgroundColor})
            *light *= kFactor;
        Pictures after = picture(input);
        for (size_t i = 0; i < after.linear.size(); ++i)
            if (i % 4 != 3) after.linear[i] /= kFactor;
        expectNear(before, after, 0, 1e-5);
        size_t differing = 0;
        for (size_t i = 0; i < before.display.size(); ++i) {
            const int apart = std::abs(int(before.display[i]) - int(after.display[i]));
            EXPECT_LE(apart, 1);
            differing += apart != 0;
        }
        EXPECT_LE(differing, scene.fog.density > 0 ? kWidth * kHeight / 500 : 0);
    }
}

// A quarter turn about the vertical axis and a move by whole metres: every product is the same
// number, sums are not.
TEST_F(Metamorphic, TheWorldMovedWithTheCamera) {
    mat4 turn(0.0f);
    turn[0] = {0, 0, -1, 0};
    turn[1] = {0, 1, 0, 0};
    turn[2] = {1, 0, 0, 0};
    turn[3] = {32, 0, -64, 1};
    for (const uint64_t seed : kSeeds)
        for (const bool shadows : {false, true}) {
            if (!isDrawn(seed, shadows)) continue;
            SCOPED_TRACE(testing::Message() << seed << (shadows ? ", shadows" : ""));
            VariedScene scene(renderer(), seed);
            scene.settings.shadows = shadows;
            // The height of fog is the world's; the move is level.
            const Pictures before = picture(scene.frame(0));
            scene.move(turn);
            // Measured: 5 of 14,400 pixels by over 1 %, and 0.0008 on the mean.
            expectNear(before, picture(scene.frame(0)), 0.003, 0.003, 0.01f);
        }
}

// Rasterising is symmetric but for edges that pass through a pixel's centre, and shadow maps are
// mirrored with the world. Patterns of the screen are not (ambient occlusion, off).
TEST_F(Metamorphic, TheWorldInAMirror) {
    mat4 mirror(1.0f);
    mirror[0][0] = -1;
    for (const uint64_t seed : kSeeds)
        for (const bool shadows : {false, true}) {
            if (!isDrawn(seed, shadows)) continue;
            SCOPED_TRACE(testing::Message() << seed << (shadows ? ", shadows" : ""));
            VariedScene scene(renderer(), seed);
            scene.settings.shadows = shadows;
            scene.settings.ambientOcclusion = AmbientOcclusion::off;
            const Pictures before = picture(scene.frame(0));
            scene.move(mirror);
            FrameInput input = scene.frame(0);
            input.view.viewFromWorld = mirror * input.view.viewFromWorld;
            const Pictures after = picture(input);
            const Difference apart = mirroredDifference(before.linear, after.linear, kWidth, 0.01f);
            // Measured: none, and 5e-6.
            EXPECT_LE(apart.differing, 0.001);
            EXPECT_LE(apart.mean, 1e-4);
            EXPECT_GT(difference(before.linear, after.linear, 0.01f).differing, 0.05);
        }
}

// A direction's length says nothing, and neither does an aspect that is the target's.
TEST_F(Metamorphic, DescriptionsThatMeanTheSame) {
    for (const uint64_t seed : kSeeds) {
        SCOPED_TRACE(seed);
        VariedScene scene(renderer(), seed);
        const Pictures before = picture(scene.frame(0));
        for (DirectionalLight& sun : scene.suns) sun.direction *= 4.0f;
        FrameInput input = scene.frame(0);
        input.view.aspect = float(kWidth) / float(kHeight);
        expectNear(before, picture(input), 0.002, 1e-4);
    }
}

}  // namespace
}  // namespace rushlight

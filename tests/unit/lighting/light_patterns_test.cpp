// Profiles and cookies as paths look them up.
#include "renderer/frame/lights.h"
#include "renderer/raytrace/bake_light.h"
#include "renderer/raytrace/path_tracer.h"
#include "tests/support/random.h"
#include "tests/support/scenes/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace rushlight {
namespace {

const std::array<float, 3> kVertical{0, 45, 90};
const std::array<float, 2> kAround{0, 90};
const std::array<float, 6> kCandela{8, 4, 0, 8, 2, 2};

LightPattern quarterSymmetric() {
    return *LightPattern::make(LightProfileDesc{"quarter", kVertical, kAround, kCandela});
}

TEST(LightPatterns, AProfileIsMirroredIntoAllQuarters) {
    const LightPattern pattern = quarterSymmetric();
    Random random(2);
    for (int i = 0; i < 300; ++i) {
        const float fall = random.uniform(0.02f, 1.5f), turn = random.uniform(0.0f, kPi / 2);
        const vec3 d(std::sin(fall) * std::cos(turn), std::sin(fall) * std::sin(turn),
                     std::cos(fall));
        const float v = fall * 180 / kPi, h = turn / (kPi / 2);
        const size_t column = v < 45 ? 0 : 1;
        const float f = v / 45 - float(column);
        const float first = std::lerp(kCandela[column], kCandela[column + 1], f);
        const float second = std::lerp(kCandela[3 + column], kCandela[3 + column + 1], f);
        const float want = std::lerp(first, second, h) / 8;
        for (const vec2 side : {vec2(1, 1), vec2(-1, 1), vec2(1, -1), vec2(-1, -1)})
            EXPECT_NEAR(pattern.factor({d.x * side.x, d.y * side.y, d.z}, 0).x, want, 0.006f)
                << v << " " << h;
        EXPECT_EQ(pattern.factor(-d, 0), vec3(0));
    }
}

// Half a turn from 90 degrees: mirrored about the plane of 90 and 270.
TEST(LightPatterns, TheHalfTurnFrom90Degrees) {
    const std::array<float, 3> around{90, 180, 270};
    const std::array<float, 6> candela{1, 1, 2, 2, 4, 4};
    const std::array<float, 2> vertical{0, 180};
    const LightPattern pattern = *LightPattern::make(
        LightProfileDesc{"half", vertical, around, candela});
    EXPECT_NEAR(pattern.factor({0, 1, 0}, 0).x, 0.25f, 1e-3f);
    EXPECT_NEAR(pattern.factor({-1, 0, 0}, 0).x, 0.5f, 1e-3f);
    EXPECT_NEAR(pattern.factor({1, 0, 0}, 0).x, 0.5f, 1e-3f);
    EXPECT_NEAR(pattern.factor({0, -1, 0}, 0).x, 1, 1e-3f);
}

TEST(LightPatterns, AFrameHasItsRollFromUpAndSurvivesAnyVector) {
    PunctualLight light;
    light.direction = {0, -1, 0};
    light.up = {0, 0, -3};
    EXPECT_EQ(patternFrameOf(light).right, vec3(1, 0, 0));
    EXPECT_EQ(patternFrameOf(light).up, vec3(0, 0, -1));
    for (const vec3& up : {vec3(0), vec3(0, 1, 0), vec3(0, -2, 0)}) {
        light.up = up;
        const LightPatternFrame frame = patternFrameOf(light);
        EXPECT_NEAR(glm::length(frame.right), 1, 1e-5f);
        EXPECT_NEAR(glm::dot(frame.right, frame.forward), 0, 1e-5f);
        EXPECT_NEAR(glm::length(glm::cross(frame.right, frame.up) + frame.forward), 0, 1e-5f);
    }
}

// A white floor under a lamp: paths see its light through the pattern, and another hash.
TEST(LightPatterns, PathsBounceThePatternsLight) {
    SerialJobs jobs;
    const auto scene = *RayScene::create(jobs);
    const Shape cube = makeCube();
    ASSERT_TRUE(scene->setMesh(MeshHandle{1}, cube.desc()));
    MaterialDesc white;
    white.metallic = 0;
    ASSERT_TRUE(scene->setMaterial(MaterialHandle{1}, white));
    Instance floor;
    floor.mesh = MeshHandle{1};
    floor.material = MaterialHandle{1};
    floor.worldFromLocal[3].y = -1;
    ASSERT_TRUE(scene->build({&floor, 1}));

    PunctualLight lamp;
    lamp.position = {0, 2, 0};
    BakeLighting lighting;
    lighting.punctual = {&lamp, 1};
    const uint64_t plainHash = hashOf(lighting);
    const BrdfTable table = makeBrdfTable(jobs);
    const auto seenAt = [&](float x) {
        const BakeLight light = *BakeLight::create(lighting, jobs);
        RayRandom random(1);
        return PathTracer(*scene, light, table, 0)
            .radiance({x, 1, 0}, {0, -1, 0}, INFINITY, 0, random);
    };
    const vec3 plain = seenAt(0.5f);
    LightPatternSet patterns;
    patterns.set(LightProfileHandle{1}, quarterSymmetric());
    const std::vector<uint8_t> tint{255, 0, 51, 255};
    patterns.set(LightCookieHandle{1},
                 *LightPattern::make(LightCookieDesc{"tint", {"tint", 1, 1, false, tint}}));
    lighting.patterns = &patterns;
    EXPECT_EQ(hashOf(lighting), plainHash);
    lamp.profile = LightProfileHandle{1};
    lamp.cookie = LightCookieHandle{1};
    EXPECT_NE(hashOf(lighting), plainHash);
    const float fall = std::atan(0.25f) * 180 / kPi;
    const vec3 got = seenAt(0.5f) / plain, want = (1 - fall / 90) * vec3(1, 0, 0.2f);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], want[c], 0.005f);
    lamp.direction = {0, 1, 0};
    EXPECT_EQ(seenAt(0.5f), vec3(0));
}

}  // namespace
}  // namespace rushlight

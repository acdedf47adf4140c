#include "engine/physics/character.h"

#include "tests/unit/engine/level_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rushlight {
namespace {

void walk(Character& character, const TriangleGrid& level, const vec3& velocity, float seconds,
          float rate) {
    const int steps = int(std::lround(seconds * rate));
    for (int i = 0; i < steps; ++i) character.step(level, velocity, 1 / rate);
}

class CharacterTest : public testing::TestWithParam<float> {};
INSTANTIATE_TEST_SUITE_P(AtRate, CharacterTest, testing::Values(5.0f, 30.0f, 60.0f, 240.0f));

TEST_P(CharacterTest, LandsOnAThinFloorFromHighUp) {
    test::Triangles triangles;
    test::addFloor(triangles, 20);
    const TriangleGrid level(triangles);
    Character character({0.3f, 60, 0.2f});
    walk(character, level, vec3(0), 8, GetParam());
    EXPECT_TRUE(character.isOnGround());
    EXPECT_NEAR(character.feet().y, 0, 1e-3f);
}

TEST_P(CharacterTest, AThinWallStopsASprint) {
    test::Triangles triangles;
    test::addFloor(triangles, 50);
    test::addQuad(triangles, {-50, 0, -3}, {50, 0, -3}, {50, 3, -3}, {-50, 3, -3});
    const TriangleGrid level(triangles);
    Character character(vec3(0));
    walk(character, level, {0, 0, -30}, 1, GetParam());
    EXPECT_NEAR(character.feet().z, -2.7f, 0.01f);
    EXPECT_NEAR(character.feet().y, 0, 1e-3f);
}

TEST_P(CharacterTest, SlidesAlongAWall) {
    test::Triangles triangles;
    test::addFloor(triangles, 50);
    test::addBox(triangles, {-50, 0, -4}, {50, 3, -3});
    const TriangleGrid level(triangles);
    Character character(vec3(0));
    walk(character, level, {3, 0, -3}, 4, GetParam());
    EXPECT_NEAR(character.feet().z, -2.7f, 0.01f);
    EXPECT_NEAR(character.feet().x, 12, 0.1f);
}

TEST_P(CharacterTest, IsHeldByACornerWithoutJitter) {
    test::Triangles triangles;
    test::addFloor(triangles, 50);
    test::addBox(triangles, {-50, 0, -4}, {50, 3, -3});
    test::addBox(triangles, {3, 0, -50}, {4, 3, 50});
    const TriangleGrid level(triangles);
    Character character(vec3(0));
    walk(character, level, {3, 0, -3}, 4, GetParam());
    const vec3 held = character.feet();
    EXPECT_NEAR(held.x, 2.7f, 0.01f);
    EXPECT_NEAR(held.z, -2.7f, 0.01f);
    walk(character, level, {3, 0, -3}, 1, GetParam());
    EXPECT_LT(glm::distance(character.feet(), held), 0.01f);
}

TEST_P(CharacterTest, CannotSqueezeOutOfAnAcuteCorner) {
    test::Triangles triangles;
    test::addFloor(triangles, 50);
    // Two walls that meet at 20 degrees at z = -5.
    const float side = 10 * std::tan(kPi / 18);
    test::addQuad(triangles, {0, 0, -5}, {side, 0, 5}, {side, 3, 5}, {0, 3, -5});
    test::addQuad(triangles, {0, 0, -5}, {-side, 0, 5}, {-side, 3, 5}, {0, 3, -5});
    const TriangleGrid level(triangles);
    Character character({0, 0, 3});
    walk(character, level, {0.3f, 0, -20}, 3, GetParam());
    // A circle of 0.3 m touches both walls 0.3 / sin(10 degrees) from the corner; 0.15 m of
    // penetration at most.
    EXPECT_GT(character.feet().z, -5 + 0.15f / std::sin(kPi / 18));
    EXPECT_LT(std::abs(character.feet().x), (character.feet().z + 5) * std::tan(kPi / 18));
}

TEST_P(CharacterTest, StepsOntoALowLedgeButNotOntoAHighOne) {
    test::Triangles triangles;
    test::addFloor(triangles, 50);
    test::addBox(triangles, {-5, 0, -4}, {5, 0.35f, -2});
    test::addBox(triangles, {-5, 0, 2}, {5, 0.6f, 4});
    const TriangleGrid level(triangles);
    Character up(vec3(0));
    walk(up, level, {0, 0, -3}, 1, GetParam());
    EXPECT_NEAR(up.feet().y, 0.35f, 1e-3f);
    Character stopped(vec3(0));
    walk(stopped, level, {0, 0, 3}, 2, GetParam());
    EXPECT_NEAR(stopped.feet().y, 0, 1e-3f);
    EXPECT_LT(stopped.feet().z, 2);
}

TEST_P(CharacterTest, WalksUpAndDownStairsOnTheGround) {
    test::Triangles triangles;
    test::addFloor(triangles, 50);
    for (int i = 0; i < 10; ++i) {
        const float z = -2 - 0.4f * float(i);
        test::addBox(triangles, {-5, 0, z - 0.4f}, {5, 0.2f * float(i + 1), z});
    }
    const TriangleGrid level(triangles);
    Character character(vec3(0));
    walk(character, level, {0, 0, -2}, 2.8f, GetParam());
    EXPECT_NEAR(character.feet().y, 2, 0.01f);
    EXPECT_TRUE(character.isOnGround());
    walk(character, level, {0, 0, 2}, 2.8f, GetParam());
    EXPECT_NEAR(character.feet().y, 0, 0.01f);
    EXPECT_TRUE(character.isOnGround());
}

TEST_P(CharacterTest, ClimbsAGentleSlopeAndNotASteepOne) {
    for (const float degrees : {30.0f, 65.0f}) {
        test::Triangles triangles;
        test::addFloor(triangles, 50);
        const float rise = 10 * std::tan(glm::radians(degrees));
        test::addQuad(triangles, {-5, 0, -2}, {5, 0, -2}, {5, rise, -12}, {-5, rise, -12});
        const TriangleGrid level(triangles);
        Character character(vec3(0));
        walk(character, level, {0, 0, -2}, 4, GetParam());
        if (degrees < 45) {
            EXPECT_GT(character.feet().y, 2.5f);
        } else {
            EXPECT_LT(character.feet().y, 1.0f);
        }
    }
}

TEST_P(CharacterTest, IsNotPressedThroughTheFloorByALowCeiling) {
    test::Triangles triangles;
    test::addFloor(triangles, 50);
    test::addQuad(triangles, {-5, 2.2f, -1}, {5, 2.2f, -1}, {5, 0.4f, -9}, {-5, 0.4f, -9});
    const TriangleGrid level(triangles);
    Character character(vec3(0));
    walk(character, level, {0, 0, -4}, 3, GetParam());
    EXPECT_NEAR(character.feet().y, 0, 0.01f);
    EXPECT_GT(character.feet().z, -4);
}

TEST(CharacterFallTest, FallsAsGalileoSays) {
    Character character({0, 100, 0});
    const TriangleGrid nothing;
    for (int i = 0; i < 60; ++i) character.step(nothing, vec3(0), 1.0f / 60);
    EXPECT_NEAR(character.feet().y, 100 - 0.5f * 9.81f, 0.01f);
    EXPECT_FALSE(character.isOnGround());
}

}  // namespace
}  // namespace rushlight

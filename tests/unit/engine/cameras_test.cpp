#include "engine/scene/cameras.h"

#include "tests/unit/engine/level_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rushlight {
namespace {

void expectNear(const vec3& actual, const vec3& expected, float tolerance) {
    EXPECT_NEAR(actual.x, expected.x, tolerance);
    EXPECT_NEAR(actual.y, expected.y, tolerance);
    EXPECT_NEAR(actual.z, expected.z, tolerance);
}

TEST(LookAnglesTest, ZeroLooksAlongMinusZ) {
    const LookAngles look;
    expectNear(look.forward(), {0, 0, -1}, 1e-6f);
    expectNear(look.right(), {1, 0, 0}, 1e-6f);
    expectNear(look.up(), {0, 1, 0}, 1e-6f);
}

TEST(LookAnglesTest, AlongIsTheInverseOfForward) {
    for (const vec3& direction : {vec3(1, 0.5f, -2), vec3(-3, -1, 0.2f), vec3(0, 0, 1)})
        expectNear(LookAngles::along(direction).forward(), glm::normalize(direction), 1e-5f);
}

TEST(LookAnglesTest, NeverTurnsOverWhenLookingStraightUpOrDown) {
    for (const float sign : {1.0f, -1.0f}) {
        LookAngles look;
        look.yaw = 0.7f;
        const vec3 right = look.right();
        for (int i = 0; i < 1000; ++i) look.turn(0, sign * 0.05f);
        EXPECT_EQ(look.yaw, 0.7f);
        EXPECT_GT(look.up().y, 0);
        EXPECT_GT(sign * look.forward().y, 0.99999f);
        expectNear(look.right(), right, 1e-6f);
        EXPECT_GT(glm::length(vec2(look.forward().x, look.forward().z)), 1e-4f);
    }
}

TEST(LookAnglesTest, StraightDownHasFiniteAngles) {
    const LookAngles look = LookAngles::along({0, -1, 0});
    EXPECT_TRUE(std::isfinite(look.yaw));
    EXPECT_EQ(look.pitch, -LookAngles::kMaxPitch);
}

TEST(LookAnglesTest, YawStaysSmallForever) {
    LookAngles look;
    for (int i = 0; i < 100000; ++i) look.turn(1, 0);
    EXPECT_LE(std::abs(look.yaw), kPi);
}

TEST(CameraPoseTest, TheViewIsARigidMotionThatPutsTheEyeAtTheOrigin) {
    CameraPose pose{{3, 2, -5}, {}};
    pose.look.turn(1.1f, -0.6f);
    const mat4 view = pose.viewFromWorld();
    expectNear(vec3(view * vec4(pose.position, 1)), vec3(0), 1e-5f);
    expectNear(vec3(view * vec4(pose.look.forward(), 0)), {0, 0, -1}, 1e-6f);
    EXPECT_NEAR(glm::determinant(mat3(view)), 1, 1e-5f);
}

/// Starts, turns off to the side, stops: the same seconds in frames of `rate` a second.
vec3 flySomewhere(int rate) {
    FlyCamera camera;
    for (int frame = 0; frame < 3 * rate; ++frame) {
        const int second = frame / rate;
        CameraIntent intent;
        intent.forward = second == 0 ? 1.0f : 0.0f;
        intent.right = second == 1 ? 1.0f : 0.0f;
        intent.fast = second == 1;
        camera.update(intent, 1.0f / float(rate));
    }
    return camera.pose.position;
}

TEST(FlyCameraTest, TakesTheSamePathAtAnyFrameRate) {
    const vec3 at240 = flySomewhere(240);
    EXPECT_GT(glm::length(at240), 10);
    expectNear(flySomewhere(30), at240, 2e-3f);
    expectNear(flySomewhere(5), at240, 2e-3f);
}

TEST(FlyCameraTest, ReachesItsSpeedAndStops) {
    FlyCamera camera;
    CameraIntent intent;
    intent.forward = 1;
    for (int i = 0; i < 120; ++i) camera.update(intent, 1.0f / 60);
    EXPECT_NEAR(glm::length(camera.velocity()), camera.speed, 1e-3f);
    for (int i = 0; i < 120; ++i) camera.update({}, 1.0f / 60);
    EXPECT_NEAR(glm::length(camera.velocity()), 0, 1e-3f);
}

TEST(FlyCameraTest, DiagonalIsNoFaster) {
    FlyCamera camera;
    CameraIntent intent;
    intent.forward = intent.right = intent.up = 1;
    for (int i = 0; i < 120; ++i) camera.update(intent, 1.0f / 60);
    EXPECT_NEAR(glm::length(camera.velocity()), camera.speed, 1e-3f);
}

TEST(FlyCameraTest, ScrollChangesTheSpeedWithinLimits) {
    FlyCamera camera;
    CameraIntent intent;
    intent.scroll = 2;
    const float before = camera.speed;
    camera.update(intent, 0.01f);
    EXPECT_GT(camera.speed, before);
    intent.scroll = 1000;
    camera.update(intent, 0.01f);
    EXPECT_EQ(camera.speed, FlyCamera::kMaxSpeed);
    intent.scroll = -1000;
    camera.update(intent, 0.01f);
    EXPECT_EQ(camera.speed, FlyCamera::kMinSpeed);
}

TriangleGrid yard() {
    test::Triangles triangles;
    test::addFloor(triangles, 20);
    test::addBox(triangles, {-20, 0, -6}, {20, 3, -5});
    test::addBox(triangles, {-1, 0, -3}, {1, 0.25f, -2});
    return TriangleGrid(triangles);
}

CameraPose walkSomewhere(int rate) {
    const TriangleGrid level = yard();
    WalkCamera camera;
    camera.spawnAt({0, 0, 0}, {});
    for (int frame = 0; frame < 4 * rate; ++frame) {
        CameraIntent intent;
        intent.forward = frame < 3 * rate ? 1.0f : 0.0f;
        intent.right = frame < 2 * rate ? 0.3f : 0.0f;
        camera.update(intent, level, 1.0f / float(rate));
    }
    return camera.pose();
}

TEST(WalkCameraTest, TakesTheSamePathAtAnyFrameRate) {
    const vec3 at240 = walkSomewhere(240).position;
    expectNear(walkSomewhere(30).position, at240, 1e-3f);
    expectNear(walkSomewhere(5).position, at240, 1e-3f);
    EXPECT_NEAR(at240.z, -4.7f, 0.02f) << "stopped by the wall";
    EXPECT_NEAR(at240.y, WalkCamera::kEyeHeight, 0.01f) << "down from the kerb again";
}

TEST(WalkCameraTest, EyesGlideUpAStep) {
    const TriangleGrid level = yard();
    WalkCamera camera;
    camera.spawnAt({0, 0, -1}, {});
    CameraIntent intent;
    intent.forward = 1;
    float highest = 0;
    float before = camera.pose().position.y;
    for (int frame = 0; frame < 45; ++frame) {
        camera.update(intent, level, 1.0f / 60);
        const float height = camera.pose().position.y;
        EXPECT_LT(std::abs(height - before), 0.1f) << "frame " << frame;
        before = height;
        highest = std::max(highest, height);
    }
    EXPECT_NEAR(highest, 0.25f + WalkCamera::kEyeHeight, 0.02f);
}

TEST(WalkCameraTest, AFallOutOfTheWorldEndsAtTheSpawn) {
    const TriangleGrid level = yard();
    WalkCamera camera;
    camera.spawnAt({2, 0, 3}, {});
    camera.placeEyesAt({{100, 1.7f, 0}, {}});
    for (int frame = 0; frame < 60 * 5; ++frame) camera.update({}, level, 1.0f / 60);
    expectNear(camera.pose().position, {2, WalkCamera::kEyeHeight, 3}, 1e-3f);
}

}  // namespace
}  // namespace rushlight

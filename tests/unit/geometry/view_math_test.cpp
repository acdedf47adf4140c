#include "renderer/geometry/view_math.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <limits>

namespace rushlight {
namespace {

View lookingFrom(const vec3& eye, const vec3& target) {
    View view;
    view.viewFromWorld = glm::lookAt(eye, target, vec3(0, 1, 0));
    return view;
}

/// Depth-buffer value of a point at this distance along the view axis.
float depthAt(const CameraMatrices& camera, float viewDepth) {
    const vec4 clip = camera.clipFromView * vec4(0, 0, -viewDepth, 1);
    return clip.z / clip.w;
}

CameraMatrices cameraOf(const View& view) { return makeCamera(view, 16.0f / 9).value(); }

View perspectiveView(float nearPlane, float farPlane) {
    View view = lookingFrom({1, 2, 3}, {4, 1, -5});
    view.nearPlane = nearPlane;
    view.farPlane = farPlane;
    return view;
}

View orthographicView() {
    View view = lookingFrom({1, 2, 3}, {4, 1, -5});
    view.perspective = false;
    view.orthoHalfHeight = 3;
    view.nearPlane = -2;
    view.farPlane = 40;
    return view;
}

TEST(ViewMath, DepthIsReversed) {
    const CameraMatrices finite = cameraOf(perspectiveView(0.25f, 100));
    EXPECT_FLOAT_EQ(depthAt(finite, 0.25f), 1);
    EXPECT_NEAR(depthAt(finite, 100), 0, 1e-7f);
    const CameraMatrices infinite = cameraOf(perspectiveView(0.25f, 0));
    EXPECT_FLOAT_EQ(depthAt(infinite, 0.25f), 1);
    EXPECT_GT(depthAt(infinite, 1e6f), 0);
    EXPECT_LT(depthAt(infinite, 1e6f), 1e-6f);
    const CameraMatrices orthographic = cameraOf(orthographicView());
    EXPECT_FLOAT_EQ(depthAt(orthographic, -2), 1);
    EXPECT_NEAR(depthAt(orthographic, 40), 0, 1e-7f);
}

TEST(ViewMath, DepthDecodesToTheDistance) {
    for (const View& view : {perspectiveView(0.1f, 50), perspectiveView(0.1f, 0)}) {
        const CameraMatrices camera = cameraOf(view);
        for (float d : {0.1f, 0.5f, 3.0f, 20.0f, 49.0f})
            EXPECT_NEAR(1 / (depthAt(camera, d) * camera.depthDecode.x + camera.depthDecode.y), d,
                        d * 1e-5f * std::max(1.0f, d));
    }
    const CameraMatrices camera = cameraOf(orthographicView());
    for (float d : {-2.0f, 0.0f, 1.0f, 39.0f})
        EXPECT_NEAR(depthAt(camera, d) * camera.depthDecode.x + camera.depthDecode.y, d,
                    1e-5f * 42);
}

TEST(ViewMath, RelativePositionUndoesTheProjection) {
    Random random(1);
    for (const View& view : {perspectiveView(0.1f, 0), orthographicView()}) {
        const CameraMatrices camera = cameraOf(view);
        for (int i = 0; i < 200; ++i) {
            const vec2 uv(random.uniform(0, 1), random.uniform(0, 1));
            const float depth = random.uniform(0.2f, 30);
            const vec3 world = camera.position + camera.relativePosition(uv, depth);
            const vec4 clip = camera.clipFromWorld * vec4(world, 1);
            EXPECT_NEAR(clip.x / clip.w * 0.5f + 0.5f, uv.x, 1e-4f);
            EXPECT_NEAR(clip.y / clip.w * 0.5f + 0.5f, uv.y, 1e-4f);
            EXPECT_NEAR(-(camera.viewFromWorld * vec4(world, 1)).z, depth, 1e-4f * depth);
        }
    }
}

// The planes against the definition of clip space: a point is inside when -w <= x, y <= w and 0 <=
// z <= w.
TEST(ViewMath, FrustumAcceptsThePointsOfClipSpace) {
    Random random(2);
    for (const View& view :
         {perspectiveView(0.5f, 30), perspectiveView(0.5f, 0), orthographicView()}) {
        const CameraMatrices camera = cameraOf(view);
        int inside = 0, outside = 0;
        for (int i = 0; i < 40000; ++i) {
            const vec3 p = camera.position + random.vector(-50, 50);
            const vec4 c = camera.clipFromWorld * vec4(p, 1);
            const float margin = 1e-3f * std::abs(c.w);
            const float least = std::min(
                {c.w - std::abs(c.x), c.w - std::abs(c.y), c.w - c.z, c.z});
            if (std::abs(least) < margin) continue;
            EXPECT_EQ(intersects(camera.frustum, p, vec3(0)), least > 0) << i;
            ++(least > 0 ? inside : outside);
        }
        EXPECT_GT(inside, 50);
        EXPECT_GT(outside, 1000);
    }
}

TEST(ViewMath, FrustumTakesBoxesThatReachIn) {
    View view;  // at the origin, along -z
    view.verticalFov = kPi / 2;
    view.aspect = 1;
    view.nearPlane = 1;
    view.farPlane = 10;
    const Frustum frustum = cameraOf(view).frustum;
    const auto sees = [&](vec3 center, float half) {
        return intersects(frustum, center, vec3(half));
    };
    EXPECT_TRUE(sees({0, 0, -5}, 0.1f));
    EXPECT_FALSE(sees({0, 0, 5}, 0.1f));
    EXPECT_FALSE(sees({0, 0, -0.5f}, 0.4f));
    EXPECT_TRUE(sees({0, 0, -0.5f}, 0.6f));
    EXPECT_FALSE(sees({0, 0, -11}, 0.9f));
    EXPECT_TRUE(sees({0, 0, -11}, 1.1f));
    EXPECT_FALSE(sees({7, 0, -5}, 0.9f));
    EXPECT_TRUE(sees({7, 0, -5}, 1.1f));
    EXPECT_FALSE(sees({0, -7, -5}, 0.9f));
    EXPECT_TRUE(sees({0, -7, -5}, 1.1f));
}

TEST(ViewMath, AnInfiniteFarPlaneSeesEverythingAhead) {
    View view;
    EXPECT_TRUE(intersects(cameraOf(view).frustum, {0, 0, -1e8f}, vec3(0)));
    EXPECT_FALSE(intersects(cameraOf(view).frustum, {0, 0, 1e8f}, vec3(0)));
}

TEST(ViewMath, AxesAndAspect) {
    const CameraMatrices camera = cameraOf(lookingFrom({0, 0, 5}, {0, 0, 0}));
    EXPECT_LT(glm::distance(camera.position, vec3(0, 0, 5)), 1e-6f);
    EXPECT_LT(glm::distance(camera.forward, vec3(0, 0, -1)), 1e-6f);
    EXPECT_LT(glm::distance(camera.right, vec3(1, 0, 0)), 1e-6f);
    EXPECT_LT(glm::distance(camera.up, vec3(0, 1, 0)), 1e-6f);
    EXPECT_FLOAT_EQ(camera.tanHalfX / camera.tanHalfY, 16.0f / 9);
    View own = lookingFrom({0, 0, 5}, {0, 0, 0});
    own.aspect = 2;
    EXPECT_FLOAT_EQ(cameraOf(own).tanHalfX / cameraOf(own).tanHalfY, 2);
}

/// Where a point lands, in [0, 1]² of the picture.
vec2 uvOf(const CameraMatrices& camera, const vec3& point) {
    const vec4 clip = camera.clipFromWorld * vec4(point, 1);
    return vec2(clip) / clip.w * 0.5f + 0.5f;
}

TEST(ViewMath, AnOffCentreFrustumIsAPartOfALargerPicture) {
    View whole = perspectiveView(0.1f, 0);
    whole.frustum = {-0.8f, 0.8f, -0.5f, 0.5f};
    View part = whole;
    part.frustum = {0, 0.8f, -0.5f, 0.1f};  // the right half, the lower three fifths
    for (const vec3& direction : {vec3(0.1f, -0.4f, -1), vec3(0.7f, 0.05f, -1)}) {
        const CameraMatrices all = cameraOf(whole), one = cameraOf(part);
        const mat4 worldFromView = glm::inverse(all.viewFromWorld);
        const vec3 point = vec3(worldFromView * vec4(direction * 3.0f, 1));
        const vec2 uv = uvOf(one, point);
        const vec2 expected = (uvOf(all, point) - vec2(0.5f, 0)) / vec2(0.5f, 0.6f);
        EXPECT_LT(glm::distance(uv, expected), 1e-5f);
        EXPECT_LT(glm::distance(one.position + one.relativePosition(uv, 3), point), 1e-4f);
        EXPECT_TRUE(intersects(one.frustum, point, 0.0f));
    }
    part.frustum = {0.8f, 0, -0.5f, 0.5f};
    EXPECT_FALSE(makeCamera(part, 1));
}

TEST(ViewMath, JitterMovesThePictureAndNoVelocity) {
    for (const View& view : {perspectiveView(0.1f, 0), orthographicView()}) {
        const CameraMatrices still = cameraOf(view);
        CameraMatrices moved = still;
        jitterCamera(moved, {0.25f, -0.5f}, 100, 50);
        const vec3 point = still.position + still.forward * 4.0f + still.right * 0.3f;
        const vec2 by = uvOf(moved, point) - uvOf(still, point);
        EXPECT_LT(glm::distance(by, vec2(-0.25f / 100, 0.5f / 50)), 1e-5f);
        EXPECT_EQ(moved.previousClipFromWorld, moved.clipFromWorld);
        const vec3 back = moved.position + moved.relativePosition(uvOf(moved, point), 4);
        EXPECT_LT(glm::distance(back, point), 1e-4f);
    }
}

TEST(ViewMath, BadViewsAreErrors) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const auto refused = [](const View& good, auto&& spoil) {
        View view = good;
        EXPECT_TRUE(makeCamera(view, 1.5f));
        spoil(view);
        const auto camera = makeCamera(view, 1.5f);
        return !camera && camera.error().kind == ErrorKind::wrongUse &&
               !camera.error().message.empty();
    };
    const View p = perspectiveView(0.1f, 0), o = orthographicView();
    EXPECT_TRUE(refused(p, [&](View& v) { v.viewFromWorld[3][0] = nan; }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.viewFromWorld[1][1] = infinity; }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.viewFromWorld = mat4(0.0f); }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.verticalFov = 0; }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.verticalFov = 4; }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.verticalFov = nan; }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.nearPlane = 0; }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.nearPlane = nan; }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.nearPlane = infinity; }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.farPlane = 0.05f; }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.farPlane = nan; }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.farPlane = infinity; }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.aspect = nan; }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.frustum = {-1, 1, 1, -1}; }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.frustum = {-1, 1, -1, infinity}; }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.jitter.x = nan; }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.jitter.y = 1.5f; }));
    EXPECT_TRUE(refused(p, [&](View& v) { v.aspect = infinity; }));
    EXPECT_TRUE(refused(o, [&](View& v) { v.orthoHalfHeight = 0; }));
    EXPECT_TRUE(refused(o, [&](View& v) { v.orthoHalfHeight = nan; }));
    EXPECT_TRUE(refused(o, [&](View& v) { v.nearPlane = nan; }));
    EXPECT_TRUE(refused(o, [&](View& v) { v.farPlane = -3; }));
    EXPECT_TRUE(refused(o, [&](View& v) { v.farPlane = infinity; }));
}

}  // namespace
}  // namespace rushlight

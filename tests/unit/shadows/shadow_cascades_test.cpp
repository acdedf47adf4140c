#include "renderer/visibility/shadow_cascades.h"

#include "shaders/interop/frame_uniforms.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

namespace rushlight {
namespace {

CameraMatrices cameraAt(const vec3& eye, const vec3& target, bool perspective = true) {
    View view;
    view.viewFromWorld = glm::lookAt(eye, target, vec3(0, 1, 0));
    view.perspective = perspective;
    view.orthoHalfHeight = 6;
    view.farPlane = perspective ? 0 : 80;
    return makeCamera(view, 1.6f).value();
}

ShadowCascadeDesc descFor(const vec3& direction) {
    ShadowCascadeDesc desc;
    desc.lightDirection = glm::normalize(direction);
    desc.resolution = 512;
    desc.distance = 60;
    desc.sceneBounds = {vec3(-500, -5, -500), vec3(500, 40, 500)};
    return desc;
}

vec3 project(const ShadowCascade& cascade, const vec3& p) {
    const vec4 clip = cascade.clipFromWorld * vec4(p, 1);
    return vec3(clip) / clip.w;
}

TEST(ShadowCascades, SmallStepsMoveAMapByWholeTexelsOnly) {
    Random random(3);
    for (int light = 0; light < 8; ++light) {
        vec3 direction = random.direction();
        direction.y = -std::abs(direction.y) - 0.1f;
        const ShadowCascadeDesc desc = descFor(direction);
        const vec3 eye = random.vector(-20, 20) + vec3(0, 25, 0), ahead(3, -1, -8);
        const ShadowCascades before = makeShadowCascades(cameraAt(eye, eye + ahead), desc);
        int moved = 0;
        for (int step = 0; step < 40; ++step) {
            const vec3 now = eye + random.vector(-1.5f, 1.5f);
            const ShadowCascades after = makeShadowCascades(cameraAt(now, now + ahead), desc);
            for (uint32_t i = 0; i < 4; ++i) {
                const ShadowCascade &a = before.cascades[i], &b = after.cascades[i];
                ASSERT_NEAR(a.metresPerTexel, b.metresPerTexel, a.metresPerTexel * 1e-5f);
                for (int p = 0; p < 3; ++p) {
                    const vec3 world = eye + ahead + random.vector(-3, 3);
                    const vec3 texels = (project(b, world) - project(a, world)) * 256.0f;
                    EXPECT_NEAR(texels.x, std::round(texels.x), 0.02f);
                    EXPECT_NEAR(texels.y, std::round(texels.y), 0.02f);
                    moved += std::abs(texels.x) > 0.5f;
                }
                EXPECT_EQ(before.rows[2], after.rows[2]) << "depth along the light does not move";
            }
        }
        EXPECT_GT(moved, 100) << "the steps are too small to show anything";
    }
}

TEST(ShadowCascades, SizeStaysAsTheCameraTurns) {
    Random random(4);
    const ShadowCascadeDesc desc = descFor({-1, -2, -0.5f});
    const vec3 eye(0, 10, 0);
    const ShadowCascades first = makeShadowCascades(cameraAt(eye, eye + vec3(0, 0, -1)), desc);
    for (int i = 0; i < 60; ++i) {
        // A turn that lowers how far the scene reaches ahead below `distance` would rightly change
        // the split.
        vec3 direction = random.direction();
        direction.y *= 0.3f;
        const ShadowCascades turned = makeShadowCascades(cameraAt(eye, eye + direction), desc);
        for (uint32_t c = 0; c < 4; ++c)
            EXPECT_NEAR(turned.cascades[c].metresPerTexel, first.cascades[c].metresPerTexel,
                        first.cascades[c].metresPerTexel * 1e-4f);
    }
}

// Every point that the camera sees up to the shadow distance lies within some cascade, and the
// cascades grow.
TEST(ShadowCascades, CoverTheCamerasSlices) {
    Random random(5);
    for (int trial = 0; trial < 60; ++trial) {
        const vec3 eye = random.vector(-30, 30) + vec3(0, 35, 0);
        const bool perspective = trial % 3 != 0;
        const CameraMatrices camera = cameraAt(eye, eye + random.direction(), perspective);
        vec3 light = random.direction();
        light.y = -std::abs(light.y) - 0.05f;
        ShadowCascadeDesc desc = descFor(light);
        desc.count = 1 + uint32_t(trial) % 4;
        const ShadowCascades cascades = makeShadowCascades(camera, desc);
        ASSERT_EQ(cascades.count, desc.count);
        for (uint32_t c = 1; c < cascades.count; ++c)
            EXPECT_GT(cascades.cascades[c].metresPerTexel, cascades.cascades[c - 1].metresPerTexel);
        for (int i = 0; i < 300; ++i) {
            const vec2 uv(random.uniform(0, 1), random.uniform(0, 1));
            const vec3 p = camera.position +
                           camera.relativePosition(uv,
                                                   random.uniform(camera.nearPlane, desc.distance));
            const Aabb& scene = desc.sceneBounds;
            if (glm::any(glm::lessThan(p, scene.low)) || glm::any(glm::greaterThan(p, scene.high)))
                continue;
            bool covered = false;
            for (uint32_t c = 0; c < cascades.count; ++c) {
                const vec3 ndc = project(cascades.cascades[c], p);
                covered |= std::abs(ndc.x) <= 1 && std::abs(ndc.y) <= 1 && ndc.z >= 0 && ndc.z <= 1;
            }
            EXPECT_TRUE(covered);
        }
    }
}

TEST(ShadowCascades, NearerToTheLightIsNearerToOne) {
    const ShadowCascades cascades = makeShadowCascades(cameraAt({0, 5, 0}, {0, 4, -8}),
                                                       descFor({0.3f, -1, 0.2f}));
    const ShadowCascade& c = cascades.cascades[0];
    EXPECT_GT(project(c, {0, 10, 0}).z, project(c, {0, 1, 0}).z);
}

TEST(ShadowCascades, CastersBeforeTheRegionCount) {
    const ShadowCascades cascades = makeShadowCascades(cameraAt({0, 5, 0}, {0, 4, -8}),
                                                       descFor({1, -2, 0.5f}));
    const Frustum& frustum = cascades.cascades[0].frustum;
    const vec3 seen(0, 5, -1), sun = -glm::normalize(vec3(1, -2, 0.5f));
    EXPECT_TRUE(intersects(frustum, seen, vec3(0.1f)));
    EXPECT_TRUE(intersects(frustum, seen + sun * 4000.0f, vec3(0.1f))) << "between it and the sun";
    EXPECT_FALSE(intersects(frustum, seen - sun * 4000.0f, vec3(0.1f))) << "in its shadow";
    EXPECT_FALSE(intersects(frustum, seen + vec3(4000, 0, 0), vec3(0.1f))) << "far to the side";
}

// The shader finds its texel by rows and uvPerMetre; the map is drawn by clipFromWorld: one place.
TEST(ShadowCascades, LookupAndDrawingAgree) {
    Random random(6);
    const ShadowCascades cascades = makeShadowCascades(cameraAt({0, 5, 0}, {3, 4, -8}),
                                                       descFor({-1, -2, -0.5f}));
    for (const ShadowCascade& c : cascades.cascades)
        for (int i = 0; i < 50; ++i) {
            const vec3 p = random.vector(-30, 30);
            const vec3 ndc = project(c, p);
            const vec4 p4(p, 1);
            const vec2 metres(glm::dot(cascades.rows[0], p4), glm::dot(cascades.rows[1], p4));
            const vec2 uv = metres * c.uvPerMetre + c.uvOffset;
            EXPECT_NEAR(uv.x, ndc.x * 0.5f + 0.5f, 1e-4f);
            EXPECT_NEAR(uv.y, ndc.y * 0.5f + 0.5f, 1e-4f);
            EXPECT_NEAR(glm::dot(cascades.rows[2], p4), ndc.z, 1e-5f);
        }
}

TEST(ShadowCascades, OneNeedNotBeLargerThanTheScene) {
    ShadowCascadeDesc desc = descFor({-1, -2, -0.5f});
    desc.distance = 0;
    desc.sceneBounds = {vec3(-1), vec3(1)};
    const ShadowCascades cascades = makeShadowCascades(cameraAt({0, 0, 200}, {0, 0, 0}), desc);
    const float sceneSide = 2 * std::sqrt(3.0f);
    EXPECT_LT(cascades.cascades[3].metresPerTexel * 512, sceneSide * 1.15f);
    for (float x : {-1.0f, 1.0f})
        for (float y : {-1.0f, 1.0f})
            for (float z : {-1.0f, 1.0f}) {
                const vec3 ndc = project(cascades.cascades[3], {x, y, z});
                EXPECT_LE(std::max({std::abs(ndc.x), std::abs(ndc.y)}), 1);
                EXPECT_GE(ndc.z, 0);
                EXPECT_LE(ndc.z, 1);
            }
}

// sunVisibility of shaders/common/shadow/sun_shadow.glsl looks into the coarser cascade too where
// the finer one fades into it.
TEST(ShadowCascades, WhatIsLeftToAFinerOneIsBeyondTheBandWhereItFades) {
    Random random(8);
    int left = 0;
    for (int light = 0; light < 6; ++light) {
        vec3 direction = random.direction();
        direction.y = -std::abs(direction.y) - 0.2f;
        ShadowCascadeDesc desc = descFor(direction);
        desc.rim = RL_SHADOW_RIM;
        const vec3 eye(0, 6, 0);
        const ShadowCascades cascades = makeShadowCascades(cameraAt(eye, eye + vec3(3, -1, -8)),
                                                           desc);
        for (int i = 0; i < 4000; ++i) {
            const uint32_t index = 1 + random.below(3);
            const vec3 center = eye + random.vector(-40, 40), half(random.uniform(0.05f, 1));
            if (!cascades.isFinerElsewhere(index, center, half)) continue;
            ++left;
            // In some finer cascade every point of the box is that far from the rim.
            float best = -1;
            for (uint32_t finer = 0; finer < index; ++finer) {
                float least = 1;
                for (int corner = 0; corner < 8; ++corner) {
                    const vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
                    const vec3 uv = project(cascades.cascades[finer], center + sign * half) * 0.5f;
                    least = std::min(least, 0.5f - std::max(std::abs(uv.x), std::abs(uv.y)));
                }
                best = std::max(best, least);
            }
            EXPECT_GE(best, float(RL_SHADOW_RIM) / 512 + float(RL_CASCADE_BAND));
        }
    }
    EXPECT_GT(left, 100);
}

}  // namespace
}  // namespace rushlight

// Fog against closed forms and numeric integrals of light scattered once.

#include "tests/support/scenes/lit_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace rushlight {
namespace {

constexpr uint32_t kWidth = 160, kHeight = 90;

float phase(float g, float cosine) {
    return (1 - g * g) / (4 * kPi * std::pow(1 + g * g - 2 * g * cosine, 1.5f));
}

class FogGl : public LitFrame {
protected:
    FogGl() : LitFrame(kWidth, kHeight) {}

    void SetUp() override {
        LitFrame::SetUp();
        input.view.viewFromWorld = mat4(1);  // at the origin, along -z
        fog().density = 0.05f;
        fog().albedo = vec3(0.8f);
        fog().anisotropy = 0;
        fog().litDistance = 80;
    }
    Fog& fog() { return input.lighting.fog; }
};

TEST_F(FogGl, AmbientFogFadesASurfaceByBeersLaw) {
    input.lighting.ambientSky = input.lighting.ambientGround = {0.4f, 0.2f, 0.1f};
    const MaterialHandle wall = glowing({0.9f, 0.5f, 0.25f});
    for (const float distance : {0.3f, 2.0f, 20.0f, 60.0f, 200.0f}) {
        instances.clear();
        addBox({0, 0, -distance - 1}, {1000, 1000, 1}, wall);
        const float through = std::exp(-fog().density * distance);
        const vec3 want = vec3(0.9f, 0.5f, 0.25f) * through +
                          vec3(0.4f, 0.2f, 0.1f) * fog().albedo * (1 - through);
        const vec3 got = centre();
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], want[c], 0.01f * want[c]) << distance;
    }
}

// What is shown and the share of what is behind that the air lets through make the frame.
TEST_F(FogGl, CanBeShownAlone) {
    input.lighting.ambientSky = input.lighting.ambientGround = {0.4f, 0.2f, 0.1f};
    const vec3 wall(0.9f, 0.5f, 0.25f);
    addBox({0, 0, -11}, {1000, 1000, 1}, glowing(wall));
    const vec3 whole = centre();
    input.settings.debugView = DebugView::fog;
    const CapturedImage alone = render();
    const size_t middle = 4 * (size_t(kHeight / 2) * kWidth + kWidth / 2);
    const float covered = alone.rgba32f[middle + 3];
    EXPECT_NEAR(covered, 1 - std::exp(-0.5f), 0.01f);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(alone.rgba32f[middle + size_t(c)] + (1 - covered) * wall[c], whole[c], 0.002f);
    fog().density = 0;
    EXPECT_EQ(centre(), vec3(0));
}

TEST_F(FogGl, HeightFogHasTheClosedFormAlongEveryRay) {
    input.lighting.ambientSky = input.lighting.ambientGround = vec3(1);
    fog() = {.density = 0.2f,
             .heightFalloff = 0.4f,
             .height = -1,
             .albedo = vec3(1),
             .anisotropy = 0,
             .litDistance = 40};
    input.view.verticalFov = 0.4f;
    const MaterialHandle black = glowing(vec3(0));
    addBox({0, 0, -31}, {1000, 1000, 1}, black);
    const CapturedImage image = render();
    for (const uint32_t y : {8u, 24u, 40u, 56u, 72u}) {
        const float up = (0.5f - (float(y) + 0.5f) / kHeight) * 2 *
                         std::tan(input.view.verticalFov / 2);
        double depth = 0;
        for (int i = 0; i < 3000; ++i) {
            const double z = (i + 0.5) * 0.01;
            depth += 0.2 * std::exp(-0.4 * (up * z + 1)) * 0.01 * std::sqrt(1 + up * up);
        }
        const float want = 1 - float(std::exp(-depth));
        EXPECT_NEAR(pixelOf(image, kWidth / 2, y).x, want, 0.015f * want) << y;
    }
}

TEST_F(FogGl, SunScattersByThePhaseFunctionAndIsShadowed) {
    const vec3 towards = glm::normalize(vec3(0.3f, 1, -0.5f));
    DirectionalLight sun;
    sun.direction = -towards;
    sun.illuminance = vec3(5);
    input.lighting.directional = {&sun, 1};
    fog().anisotropy = 0.6f;
    addBox({0, 0, -41}, {30, 30, 1}, glowing(vec3(0))).flags = 0;
    const float through = std::exp(-fog().density * 40);
    // Light goes on towards the eye, +z, from where it came.
    const float want = 5 * phase(0.6f, glm::dot(-towards, vec3(0, 0, 1))) * 0.8f * (1 - through);
    EXPECT_NEAR(centre().x, want, 0.01f * want);
    addBox({0, 20, -20}, {40, 1, 60}, glowing(vec3(0)));  // a roof
    EXPECT_LT(centre().x, 0.02f * want);
}

TEST_F(FogGl, LampsScatterAsTheIntegralAlongTheRaySays) {
    fog().anisotropy = 0.4f;
    input.view.verticalFov = 0.1f;  // froxels as fine as those of a large picture
    addBox({0, 0, -41}, {100, 100, 1}, glowing(vec3(0)));
    for (const vec3& place : {vec3(0, 2, -10), vec3(0, 0.3f, -6), vec3(-3, 1, -25)}) {
        PunctualLight lamp;
        lamp.position = place;
        lamp.intensity = vec3(100);
        input.lighting.punctual = {&lamp, 1};
        double want = 0;
        for (int i = 0; i < 40000; ++i) {
            const double z = (i + 0.5) * 0.001;
            const vec3 to = place - vec3(0, 0, -z);
            const double d2 = glm::dot(to, to);
            want += 100 / d2 * phase(0.4f, float(-to.z / std::sqrt(d2))) * 0.05 * 0.8 *
                    std::exp(-0.05 * z) * 0.001;
        }
        EXPECT_NEAR(centre().x, want, 0.04 * want) << place.y;
    }
}

/// Points on a light and its normals there; each stands for as much of its surface.
std::vector<std::pair<vec3, vec3>> pointsOf(const AreaLight& light, float& areaOfOne) {
    std::vector<std::pair<vec3, vec3>> points;
    constexpr int kSteps = 24;
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const vec2 u = (vec2(i % kSteps, i / kSteps) + 0.5f) / float(kSteps);
        const float phi = 2 * kPi * u.y;
        if (light.shape == AreaShape::sphere) {
            const float z = 2 * u.x - 1, ring = std::sqrt(1 - z * z);
            const vec3 n(ring * std::cos(phi), ring * std::sin(phi), z);
            points.push_back({light.position + light.radius * n, n});
            areaOfOne = 4 * kPi * light.radius * light.radius;
        } else if (light.shape == AreaShape::tube) {
            const vec3 axis = glm::normalize(light.halfX),
                       side = glm::normalize(glm::cross(axis, vec3(0.3f, 0.5f, 0.7f)));
            const vec3 n = std::cos(phi) * side + std::sin(phi) * glm::cross(axis, side);
            points.push_back({light.position + light.halfX * (2 * u.x - 1) + light.radius * n, n});
            areaOfOne = 4 * kPi * light.radius * glm::length(light.halfX);
        } else {
            const vec2 at = light.shape == AreaShape::disk
                                ? std::sqrt(u.x) * vec2(std::cos(phi), std::sin(phi))
                                : 2.0f * u - 1.0f;
            points.push_back({light.position + light.halfX * at.x + light.halfY * at.y,
                              glm::normalize(glm::cross(light.halfX, light.halfY))});
            areaOfOne = (light.shape == AreaShape::disk ? kPi : 4) * glm::length(light.halfX) *
                        glm::length(light.halfY);
        }
    }
    areaOfOne /= kSteps * kSteps;
    return points;
}

TEST_F(FogGl, AreaLightsScatterAsTheIntegralOverThemAndTheRaySays) {
    fog().anisotropy = 0.3f;
    input.view.verticalFov = 0.1f;
    addBox({0, 0, -41}, {100, 100, 1}, glowing(vec3(0)));
    AreaLight lights[4];
    lights[0].position = {0.5f, 1.5f, -8};
    lights[0].halfX = {0.6f, 0, 0};
    lights[0].halfY = {0, 0, 1};  // shines down
    lights[1].shape = AreaShape::disk;
    lights[1].position = {-2, 0.2f, -12};
    lights[1].halfX = {0, 0, -0.8f};
    lights[1].halfY = {0, 0.8f, 0};  // shines along +x
    lights[2].shape = AreaShape::sphere;
    lights[2].position = {0, 1, -15};
    lights[2].radius = 0.4f;
    lights[3].shape = AreaShape::tube;
    lights[3].position = {0.8f, 0.2f, -6};
    lights[3].halfX = {0.2f, 1.2f, 0.1f};  // across: its ends, left out below, show little
    lights[3].radius = 0.05f;
    for (AreaLight& light : lights) {
        light.luminance = vec3(40);
        input.lighting.area = {&light, 1};
        float area = 0;
        const auto points = pointsOf(light, area);
        double want = 0;
        for (int i = 0; i < 4000; ++i) {
            const float z = (float(i) + 0.5f) * 0.01f;
            double in = 0;
            for (const auto& [point, normal] : points) {
                const vec3 to = point - vec3(0, 0, -z);
                const float d2 = glm::dot(to, to), facing = -glm::dot(to, normal) / std::sqrt(d2);
                if (facing > 0)
                    in += double(40 * facing * area / d2 * phase(0.3f, -to.z / std::sqrt(d2)));
            }
            want += in * 0.05 * 0.8 * std::exp(-0.05 * double(z)) * 0.01;
        }
        EXPECT_NEAR(centre().x, want, 0.05 * want) << int(light.shape);
    }
}

TEST_F(FogGl, AreaLightsCastShadowsInIt) {
    addBox({0, 0, -41}, {100, 100, 1}, glowing(vec3(0)));
    AreaLight light;
    light.shape = AreaShape::sphere;
    light.position = {0, 3, -10};
    light.luminance = vec3(100);
    light.castsShadow = true;
    input.lighting.area = {&light, 1};
    input.settings.lightShadows = true;
    const float open = centre().x;
    addBox({0, 2, -10}, {30, 0.1f, 30}, glowing(vec3(0)));
    for (const ShadowFilter filter : {ShadowFilter::hard, ShadowFilter::soft}) {
        input.settings.shadowFilter = filter;
        EXPECT_LT(centre().x, 0.03f * open);
    }
}

TEST_F(FogGl, BlendedSurfacesAndEmissionLieInTheFogToo) {
    input.lighting.ambientSky = input.lighting.ambientGround = vec3(0.5f);
    addBox({0, 0, -61}, {100, 100, 1}, glowing(vec3(0)));
    MaterialDesc glass;
    glass.baseColor = {1, 1, 1, 0.5f};
    glass.unlit = true;
    glass.alphaMode = AlphaMode::blend;
    addBox({0, 0, -21}, {5, 5, 1}, *renderer->createMaterial(glass));
    const auto fogOver = [&](float radiance, float distance) {
        const float through = std::exp(-fog().density * distance);
        return radiance * through + 0.5f * 0.8f * (1 - through);
    };
    // Two faces of the box, half of each.
    const float behind = fogOver(0, 60), back = fogOver(1, 22), front = fogOver(1, 20);
    const float once = 0.5f * front + 0.5f * behind;
    const float twice = 0.5f * front + 0.5f * (0.5f * back + 0.5f * behind);
    const float got = centre().x;
    EXPECT_LT(std::min(std::abs(got - once), std::abs(got - twice)), 0.01f * once) << got;
}

// Nothing but background: the fog on the whole way, which rising rays leave and level ones do not.
TEST_F(FogGl, TheBackgroundLiesBehindAllOfTheFog) {
    const vec3 sky(2, 1, 0.5f), ambient(0.4f, 0.2f, 0.1f);
    input.lighting.ambientSky = input.lighting.ambientGround = ambient;
    input.lighting.backgroundColor = sky;
    fog() = {.density = 0.03f,
             .heightFalloff = 0.1f,
             .height = -2,
             .albedo = vec3(0.8f),
             .anisotropy = 0,
             .litDistance = 30};
    const auto expectAt = [&](const CapturedImage& image, uint32_t y, float through) {
        const vec3 want = sky * through + ambient * 0.8f * (1 - through),
                   got = pixelOf(image, kWidth / 2, y);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(got[c], want[c], 0.01f * want[c]) << y << ": " << through;
    };
    // The integral of density * exp(-falloff * (rise * t - height)) over all t, rise being the sine
    // of the ray's elevation.
    const auto throughAll = [&](float rise) {
        return rise <= 0 ? 0.0f
                         : std::exp(-fog().density * std::exp(fog().heightFalloff * fog().height) /
                                    (fog().heightFalloff * rise));
    };
    const CapturedImage image = render();
    for (const uint32_t y : {4u, 14u, 24u, 34u, 60u, 80u}) {
        const float up = (1 - (float(y) + 0.5f) / kHeight * 2) *
                         std::tan(input.view.verticalFov / 2);
        expectAt(image, y, throughAll(up / std::sqrt(1 + up * up)));
    }
    input.view.perspective = false;
    input.view.farPlane = 50;
    input.view.orthoHalfHeight = 0.01f;
    for (const float rise : {-0.3f, 0.2f, 0.7f}) {
        const vec3 forward(0, rise, -std::sqrt(1 - rise * rise));
        input.view.viewFromWorld = glm::lookAt(vec3(0), forward, vec3(0, 1, 0));
        expectAt(render(), kHeight / 2, throughAll(rise));
    }
}

// What moves is drawn forward, for the G-buffer keeps its velocity where else emission is.
TEST_F(FogGl, WhatGlowsIsBehindItMovingOrNot) {
    const vec3 emitted(3, 1.5f, 0.75f), ambient(0.4f, 0.2f, 0.1f);
    input.lighting.ambientSky = input.lighting.ambientGround = ambient;
    MaterialDesc desc;
    desc.baseColor = {0, 0, 0, 1};
    desc.metallic = 1;  // reflects nothing
    desc.emissive = emitted;
    const MaterialHandle material = *renderer->createMaterial(desc);
    for (const float distance : {5.0f, 20.0f, 60.0f}) {
        instances.clear();
        Instance& box = addBox({0, 0, -distance - 1}, {1000, 1000, 1}, material);
        const mat4x3 before = glm::translate(mat4(1), vec3(0.1f, 0, 0)) * mat4(box.worldFromLocal);
        const float through = std::exp(-fog().density * distance);
        const vec3 want = emitted * through + ambient * fog().albedo * (1 - through);
        for (const bool moves : {false, true}) {
            if (moves) box.flags |= uint32_t(kInstanceMoving);
            input.previousTransforms = {&before, 1};
            const vec3 got = centre();
            EXPECT_EQ(hasPass("forward"), moves);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(got[c], want[c], 0.02f * want[c])
                    << distance << " metres, moves " << moves;
        }
    }
}

TEST_F(FogGl, WithoutDensityThereIsNoPass) {
    fog().density = 0;
    render();
    EXPECT_FALSE(hasPass("fog"));
}

TEST_F(FogGl, BadValuesAreErrors) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::function<void(Fog&)> faults[] = {
        [](Fog& f) { f.density = -1; },       [&](Fog& f) { f.density = nan; },
        [](Fog& f) { f.heightFalloff = -1; }, [&](Fog& f) { f.height = nan; },
        [](Fog& f) { f.albedo.y = 1.5f; },    [&](Fog& f) { f.albedo.z = nan; },
        [](Fog& f) { f.anisotropy = 1; },     [](Fog& f) { f.litDistance = 0; }};
    for (const auto& fault : faults) {
        FrameInput bad = input;
        fault(bad.lighting.fog);
        EXPECT_FALSE(renderer->renderOffscreen(bad, kWidth, kHeight, CaptureKind::hdr));
    }
}

}  // namespace
}  // namespace rushlight

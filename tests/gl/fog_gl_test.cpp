// Fog against closed forms and numeric integrals of light scattered once.

#include "tests/support/lit_frame.h"

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

TEST_F(FogGl, HeightFogHasTheClosedFormAlongEveryRay) {
    input.lighting.ambientSky = input.lighting.ambientGround = vec3(1);
    fog() = {.density = 0.2f, .heightFalloff = 0.4f, .height = -1, .albedo = vec3(1), .anisotropy = 0,
             .litDistance = 40};
    input.view.verticalFov = 0.4f;
    const MaterialHandle black = glowing(vec3(0));
    addBox({0, 0, -31}, {1000, 1000, 1}, black);
    const CapturedImage image = render();
    for (const uint32_t y : {8u, 24u, 40u, 56u, 72u}) {
        const float up = (0.5f - (float(y) + 0.5f) / kHeight) * 2 * std::tan(input.view.verticalFov / 2);
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

// Lights on a plane against their closed forms, by whole frames.
#include "tests/support/scenes/lit_plane.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rushlight {
namespace {

using LightsGl = LitPlane;

TEST_F(LightsGl, APointLightFallsOffByTheInverseSquareAndTheCosine) {
    PunctualLight light;
    light.position = {0.4f, 1.1f, -0.3f};
    light.intensity = vec3(5);
    input.lighting.punctual = {&light, 1};
    expectIrradiance(
        [&](vec3 p) {
            const vec3 to = light.position - p;
            const float d2 = glm::dot(to, to);
            return 5 / d2 * to.y / std::sqrt(d2);
        },
        0.05f);
}

TEST_F(LightsGl, ASpotFallsOffBetweenItsCones) {
    PunctualLight light;
    light.position = {-0.3f, 1.5f, 0.2f};
    light.intensity = vec3(8);
    light.direction = glm::normalize(vec3(0.2f, -1, 0.1f));
    light.innerConeAngle = 0.4f;
    light.outerConeAngle = 0.7f;
    input.lighting.punctual = {&light, 1};
    // KHR_lights_punctual: the square of the clamped linear step between the cones' cosines.
    expectIrradiance(
        [&](vec3 p) {
            const vec3 to = light.position - p;
            const float d2 = glm::dot(to, to), d = std::sqrt(d2);
            const float cosine = -glm::dot(to / d, light.direction);
            const float t = std::clamp(
                (cosine - std::cos(0.7f)) / (std::cos(0.4f) - std::cos(0.7f)), 0.0f, 1.0f);
            return 8 / d2 * to.y / d * t * t;
        },
        0.05f);
}

// A sphere that is wholly above the horizon lights a surface with pi L (r / d)² cos.
TEST_F(LightsGl, ASphereLightsByItsSolidAngle) {
    AreaLight light;
    light.shape = AreaShape::sphere;
    light.position = {0.2f, 1.2f, 0.1f};
    light.radius = 0.4f;
    light.luminance = vec3(3);
    input.lighting.area = {&light, 1};
    expectIrradiance(
        [&](vec3 p) {
            const vec3 to = light.position - p;
            const float d2 = glm::dot(to, to);
            return kPi * 3 * light.radius * light.radius / d2 * to.y / std::sqrt(d2);
        },
        0.05f);
}

// Lambert's polygon sum, written for this rectangle: it reaches down to the plane, and half of it
// below.
TEST_F(LightsGl, ARectangleLightsByWhatIsAboveTheHorizon) {
    AreaLight light;
    light.position = {0, 0, -1};
    light.halfX = {1, 0, 0};
    light.halfY = {0, 1, 0};  // the front looks along +z
    light.luminance = vec3(3);
    input.lighting.area = {&light, 1};
    expectIrradiance(
        [&](vec3 p) {
            if (p.z < -1) return 0.0f;
            double sum = 0;
            constexpr int kSteps = 64;
            for (int i = 0; i < kSteps; ++i)
                for (int k = 0; k < kSteps; ++k) {
                    const vec3 q(2 * (float(i) + 0.5f) / kSteps - 1, (float(k) + 0.5f) / kSteps,
                                 -1);
                    const vec3 to = q - p;
                    const float d2 = glm::dot(to, to);
                    sum += double(3 * to.y * -to.z / (d2 * d2) * 2 / (kSteps * kSteps));
                }
            // Beside the light the midpoint sum itself is not exact.
            return p.z > -0.9f ? float(sum) : -1.0f;
        },
        0.05f);
}

TEST_F(LightsGl, LightsOfAllClassesAddUp) {
    PunctualLight point;
    point.position = {0.4f, 1.1f, -0.3f};
    AreaLight area;
    area.shape = AreaShape::tube;
    area.position = {0, 1, 0.5f};
    area.luminance = vec3(4);
    MaterialDesc material;
    material.roughness = 0.4f;
    input.lighting.punctual = {&point, 1};
    const CapturedImage onlyPoint = render(material);
    input.lighting.area = {&area, 1};
    const CapturedImage both = render(material);
    input.lighting.punctual = {};
    const CapturedImage onlyArea = render(material);
    float brightest = 0;
    for (size_t i = 0; i < both.rgba32f.size(); i += 4) {
        const float sum = onlyPoint.rgba32f[i] + onlyArea.rgba32f[i];
        EXPECT_NEAR(both.rgba32f[i], sum, 0.002f * sum + 1e-5f);
        brightest = std::max(brightest, onlyArea.rgba32f[i]);
    }
    EXPECT_GT(brightest, 0.5f);
}

TEST_F(LightsGl, EmissiveSurfacesGlowThroughBloom) {
    const auto beside = [&](bool bloom) {
        input.settings.bloom = bloom;
        input.view.viewFromWorld = glm::lookAt(vec3(-10, 5, 0), vec3(-10, 0, 0), vec3(0, 0, -1));
        MaterialDesc material;
        material.emissive = vec3(20);
        const CapturedImage image = render(material, CaptureKind::display);
        // The plane ends in the middle of the picture at x = -9 m.
        const size_t row = size_t(kSide / 2) * kSide;
        EXPECT_EQ(image.rgba8[(row + kSide - 4) * 4], 255);
        return image.rgba8[(row + kSide * 3 / 4 - 6) * 4];
    };
    EXPECT_EQ(beside(false), 0);
    EXPECT_GT(beside(true), 20);
}

}  // namespace
}  // namespace rushlight

// Lights on a plane against their closed forms, by whole frames.
#include "engine/core/jobs.h"
#include "interop/brdf.h"
#include "renderer/frame/brdf_table.h"
#include "tests/support/lit_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace rushlight {
namespace {

constexpr uint32_t kSide = 96;
constexpr float kHalf = 2;  // metres that the picture shows to each side of the origin

class LightsGl : public LitFrame {
protected:
    LightsGl() : LitFrame(kSide, kSide) {}

    void SetUp() override {
        LitFrame::SetUp();
        const std::vector<vec3> corners{{-9, 0, -9}, {-9, 0, 9}, {9, 0, 9}, {9, 0, -9}};
        const std::vector<vec3> normals(4, vec3(0, 1, 0));
        const std::vector<uint32_t> indices{0, 1, 2, 0, 2, 3};
        MeshDesc plane;
        plane.label = "plane";
        plane.positions = corners;
        plane.normals = normals;
        plane.indices = indices;
        plane_ = renderer->createMesh(plane).value();
        lookDown(kHalf, 5);
        input.settings.dither = false;
        input.settings.toneMap = ToneMap::none;
        input.settings.antiAliasing = AntiAliasing::off;
    }
    CapturedImage render(const MaterialDesc& material, CaptureKind kind = CaptureKind::hdr) {
        const MaterialHandle handle = renderer->createMaterial(material).value();
        Instance instance;
        instance.mesh = plane_;
        instance.material = handle;
        instances = {instance};
        const CapturedImage image = LitFrame::render(kind);
        renderer->destroy(handle);
        return image;
    }
    /// The irradiance that each pixel's radiance means: the diffuse light alone, as white less black.
    std::vector<float> irradiance() {
        MaterialDesc material;
        material.metallic = 0;
        const CapturedImage white = render(material);
        material.baseColor = {0, 0, 0, 1};
        const CapturedImage black = render(material);
        SerialJobs jobs;
        const vec2 table = makeBrdfTable(jobs).lookUp(1, 1);
        const vec3 albedo = interop::makeShadingPoint(vec3(0), 0, 1, {0, 0, 1}, {0, 0, 1}, table).specularAlbedo;
        std::vector<float> result;
        for (size_t i = 0; i < white.rgba32f.size(); i += 4)
            result.push_back((white.rgba32f[i] - black.rgba32f[i]) * kPi / (1 - albedo.x));
        return result;
    }
    /// Compares with `expected(point on the plane)` where that is above `least`, within one in a hundred. Where it is
    /// negative nothing is known; elsewhere there must be hardly any light.
    void expectIrradiance(const std::function<float(vec3)>& expected, float least) {
        const std::vector<float> got = irradiance();
        ASSERT_EQ(got.size(), size_t(kSide) * kSide);
        float worst = 0;
        size_t compared = 0;
        for (uint32_t y = 0; y < kSide; ++y)
            for (uint32_t x = 0; x < kSide; ++x) {
                const vec3 point((2 * (float(x) + 0.5f) / kSide - 1) * kHalf, 0,
                                 (2 * (float(y) + 0.5f) / kSide - 1) * kHalf);
                const float truth = expected(point), value = got[y * kSide + x];
                if (truth < 0) continue;
                if (truth <= least) {
                    EXPECT_LE(value, least * 1.1f + 1e-4f) << x << " " << y;
                    continue;
                }
                worst = std::max(worst, std::abs(value / truth - 1));
                ++compared;
            }
        EXPECT_LT(worst, 0.01f);
        EXPECT_GT(compared, 500u);
    }

    MeshHandle plane_;
};

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
            const float t = std::clamp((cosine - std::cos(0.7f)) / (std::cos(0.4f) - std::cos(0.7f)), 0.0f, 1.0f);
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

// Lambert's polygon sum, written for this rectangle: it reaches down to the plane, and half of it below.
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
                    const vec3 q(2 * (float(i) + 0.5f) / kSteps - 1, (float(k) + 0.5f) / kSteps, -1);
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

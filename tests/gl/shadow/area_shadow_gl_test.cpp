// Shadows of area lights against rays to points spread over them.

#include "engine/core/jobs.h"
#include "renderer/raytrace/ray_scene.h"
#include "tests/support/scenes/lit_frame.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kSide = 128;
constexpr float kHalf = 2;

/// Of light that would fall on a place of the ground: the part that arrives.
struct ShadowRow {
    std::vector<float> got, truth;  ///< along the pictures' middle, from the left

    /// Metres over which the share is at most, and at least, this; along the row.
    static float width(const std::vector<float>& shares, float low, float high) {
        size_t count = 0;
        for (float share : shares) count += share >= low && share <= high;
        return float(count) * 2 * kHalf / kSide;
    }
};

// A slab above the ground, a light above the slab, and a camera between slab and ground.
class AreaShadowGl : public LitFrame {
protected:
    AreaShadowGl() : LitFrame(kSide, kSide) {}

    void SetUp() override {
        LitFrame::SetUp();
        rays = RayScene::create(jobs).value();
        matte.metallic = 0;
        material = *renderer->createMaterial(matte);
        cube = makeCube();
        ASSERT_TRUE(rays->setMaterial(material, matte));
        addBox({0, -0.5f, 0}, {6, 0.5f, 6}, material);
        addBox({0, 0.7f, 0}, {0.5f, 0.02f, 0.8f}, material);
        const MeshDesc desc = cube.desc("box");
        ASSERT_TRUE(rays->setMesh(instances[0].mesh, desc));
        ASSERT_TRUE(rays->build(instances));
        lookDown(kHalf, 0.5f);
        input.settings.dither = false;
        input.settings.antiAliasing = AntiAliasing::off;
        input.settings.lightShadows = true;
        input.settings.shadowFilter = ShadowFilter::soft;
        input.lighting.area = {&light, 1};
        light.luminance = vec3(50);
        light.castsShadow = true;
    }
    static vec3 place(uint32_t x, uint32_t y) {
        return {(2 * (float(x) + 0.5f) / kSide - 1) * kHalf, 0,
                (2 * (float(y) + 0.5f) / kSide - 1) * kHalf};
    }
    /// A point of the light, its normal; `u` in the unit square.
    std::pair<vec3, vec3> lightPoint(vec2 u, const vec3& towards) const {
        const float angle = 2 * kPi * u.y;
        const vec2 disk = std::sqrt(u.x) * vec2(std::cos(angle), std::sin(angle));
        switch (light.shape) {
            case AreaShape::rectangle:
                return {light.position + light.halfX * (2 * u.x - 1) + light.halfY * (2 * u.y - 1),
                        glm::normalize(glm::cross(light.halfX, light.halfY))};
            case AreaShape::disk:
                return {light.position + light.halfX * disk.x + light.halfY * disk.y,
                        glm::normalize(glm::cross(light.halfX, light.halfY))};
            case AreaShape::sphere: {
                const float z = 2 * u.x - 1, ring = std::sqrt(1 - z * z);
                const vec3 n(ring * std::cos(angle), z, ring * std::sin(angle));
                return {light.position + light.radius * n, n};
            }
            case AreaShape::tube: break;
        }
        const vec3 axis = glm::normalize(light.halfX);
        const vec3 side = glm::normalize(glm::cross(axis, towards)), up = glm::cross(axis, side);
        const vec3 n = std::cos(angle) * side + std::sin(angle) * up;
        return {light.position + light.halfX * (2 * u.x - 1) + light.radius * n, n};
    }
    float truthAt(const vec3& p) const {
        double all = 0, arrives = 0;
        constexpr int kSteps = 24;
        for (int i = 0; i < kSteps * kSteps; ++i) {
            const vec2 u = (vec2(i % kSteps, i / kSteps) + 0.5f) / float(kSteps);
            const auto [point, normal] = lightPoint(u, light.position - p);
            const vec3 to = point - p;
            const float d2 = glm::dot(to, to), facing = -glm::dot(to, normal);
            if (facing <= 0 || to.y <= 0) continue;
            const double weight = double(to.y * facing / (d2 * d2));
            all += weight;
            Ray ray;
            ray.origin = p + vec3(0, 1e-4f, 0);
            ray.direction = to / std::sqrt(d2);
            ray.farthest = std::sqrt(d2) - 1e-3f;
            if (!rays->occluded(ray)) arrives += weight;
        }
        return float(arrives / all);
    }
    std::vector<float> shares() {
        const CapturedImage shadowed = render();
        input.settings.lightShadows = false;
        const CapturedImage open = render();
        input.settings.lightShadows = true;
        std::vector<float> result;
        for (size_t i = 0; i < open.rgba32f.size(); i += 4) {
            EXPECT_GT(open.rgba32f[i], 1e-3f);
            result.push_back(shadowed.rgba32f[i] / open.rgba32f[i]);
        }
        return result;
    }
    /// The share of light by rays: its mean difference, and the widths of umbra and penumbra along
    /// the middle row.
    void expectAsByRays(float meanError, float metres) {
        const std::vector<float> got = shares();
        ShadowRow row;
        double sum = 0;
        for (uint32_t y = 0; y < kSide; y += 4)
            for (uint32_t x = 0; x < kSide; ++x)
                sum += double(std::abs(got[y * kSide + x] - truthAt(place(x, y))));
        EXPECT_LT(sum / (kSide * kSide / 4), double(meanError));
        for (uint32_t x = 0; x < kSide; ++x) {
            float mean = 0;  // the slab's edges are straight there
            for (uint32_t y = kSide / 2 - 4; y < kSide / 2 + 4; ++y) mean += got[y * kSide + x] / 8;
            row.got.push_back(mean);
            row.truth.push_back(truthAt(place(x, kSide / 2)));
        }
        const auto compare = [&](const char* what, float low, float high) {
            const float a = ShadowRow::width(row.got, low, high),
                        b = ShadowRow::width(row.truth, low, high);
            EXPECT_NEAR(a, b, metres) << what;
            std::cout << what << " " << a << " m, by rays " << b << " m; ";
        };
        compare("umbra", 0, 0.1f);
        compare("penumbra", 0.1f, 0.9f);
        std::cout << "mean difference " << sum / (kSide * kSide / 4) << std::endl;
    }

    SerialJobs jobs;
    std::unique_ptr<RayScene> rays;
    Shape cube;
    MaterialDesc matte;
    MaterialHandle material;
    AreaLight light;
};

TEST_F(AreaShadowGl, ARectangleHasTheUmbraAndPenumbraOfRays) {
    light.position = {0, 2.6f, 0};
    light.halfX = {0.3f, 0, 0};
    light.halfY = {0, 0, 0.15f};  // the front looks down
    expectAsByRays(0.008f, 0.1f);
    EXPECT_EQ(renderer->report().shadowViewsDrawn + renderer->report().shadowViewsCached, 0u)
        << "the last picture was without shadows";
    render();
    EXPECT_EQ(renderer->report().shadowViewsDrawn + renderer->report().shadowViewsCached, 5u);
}

TEST_F(AreaShadowGl, ASphereHasTheUmbraAndPenumbraOfRays) {
    light.shape = AreaShape::sphere;
    light.position = {0.3f, 2.4f, 0.2f};
    light.radius = 0.25f;
    expectAsByRays(0.008f, 0.1f);
}

TEST_F(AreaShadowGl, ADiskAndATubeToo) {
    light.shape = AreaShape::disk;
    light.position = {-0.4f, 2.5f, 0};
    light.halfX = {0.25f, 0, 0};
    light.halfY = {0, 0, 0.4f};
    expectAsByRays(0.008f, 0.1f);
    light.shape = AreaShape::tube;
    light.position = {0, 2.3f, -0.3f};
    light.halfX = {0.4f, 0, 0};
    light.radius = 0.05f;
    expectAsByRays(0.008f, 0.1f);
}

TEST_F(AreaShadowGl, HardShadowsAreThoseOfItsMiddle) {
    input.settings.shadowFilter = ShadowFilter::hard;
    light.shape = AreaShape::sphere;
    light.position = {0, 2.8f, 0};
    light.radius = 0.1f;
    const std::vector<float> got = shares();
    // The slab's lower edge seen from the middle: x * 2.8 / (2.8 - 0.68)
    const float edge = 0.5f * 2.8f / (2.8f - 0.72f);
    std::vector<float> row(got.begin() + kSide / 2 * kSide, got.begin() + (kSide / 2 + 1) * kSide);
    EXPECT_NEAR(ShadowRow::width(row, 0, 0.5f), 2 * edge, 0.07f);
}

TEST_F(AreaShadowGl, WhatStandsForTheLightHidesNothing) {
    light.shape = AreaShape::tube;
    light.position = {0, 2.3f, 0};
    light.halfX = {0, 0.4f, 0};  // stands: the ground sees its end
    light.radius = 0.05f;
    instances.pop_back();
    matte.doubleSided = true;  // else what is seen from within is culled
    addBox(light.position, {0.035f, 0.4f, 0.035f}, *renderer->createMaterial(matte));
    ASSERT_TRUE(rays->build(std::span(instances).first(1)));
    for (const float share : shares()) EXPECT_GT(share, 0.99f);
}

TEST_F(AreaShadowGl, ViewsAreKeptWhileTheCameraMoves) {
    light.shape = AreaShape::sphere;
    light.position = {0, 2.4f, 0};
    light.range = 10;
    render();
    EXPECT_EQ(renderer->report().shadowViewsDrawn, 6u);
    EXPECT_EQ(renderer->report().shadowLights, 1u);
    for (int i = 0; i < 3; ++i) {
        input.view.viewFromWorld = glm::lookAt(vec3(0.1f * float(i), 0.5f, 0), vec3(0),
                                               vec3(0, 0, -1));
        render();
        EXPECT_EQ(renderer->report().shadowViewsDrawn, 0u);
        EXPECT_EQ(renderer->report().shadowViewsCached, 6u);
    }
    light.luminance *= 0.5f;
    render();
    EXPECT_EQ(renderer->report().shadowViewsDrawn, 0u) << "how bright it is changes no shadow";
    light.range = 20;
    render();
    EXPECT_EQ(renderer->report().shadowViewsDrawn, 6u) << "it reaches less far";
    instances[1].worldFromLocal[3].x += 0.1f;
    render();
    EXPECT_GT(renderer->report().shadowViewsDrawn, 0u) << "the slab moved";
    light.castsShadow = false;
    render();
    EXPECT_EQ(renderer->report().shadowViewsDrawn + renderer->report().shadowViewsCached, 0u);
}

}  // namespace
}  // namespace rushlight

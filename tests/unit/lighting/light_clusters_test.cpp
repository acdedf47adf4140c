#include "renderer/lighting/clusters/light_clusters.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

namespace rushlight {
namespace {

SerialJobs jobs;
constexpr uint32_t kWidth = 700, kHeight = 450;  // neither is a multiple of a tile

CameraMatrices cameraAt(const vec3& eye, const vec3& target, bool perspective) {
    View view;
    view.viewFromWorld = glm::lookAt(eye, target, vec3(0, 1, 0));
    view.perspective = perspective;
    view.orthoHalfHeight = 8;
    view.nearPlane = perspective ? 0.1f : -10;  // an orthographic view may begin behind the eye
    view.farPlane = perspective ? 0 : 60;
    return makeCamera(view, float(kWidth) / kHeight).value();
}

/// The list of a point's froxel, found as the shaders find it (common/light/lighting.glsl).
std::vector<uint16_t> listAt(const LightClusters& clusters, vec2 uv, float viewDepth) {
    const uint32_t x = std::min(uint32_t(uv.x * kWidth) / clusters.tilePixels, clusters.tilesX - 1);
    const uint32_t y = std::min(uint32_t(uv.y * kHeight) / clusters.tilePixels,
                                clusters.tilesY - 1);
    const float slice = std::log2(std::max(viewDepth, 1e-6f)) * clusters.sliceScale +
                        clusters.sliceBias;
    const uint32_t z = uint32_t(std::clamp(slice, 0.0f, float(clusters.slices - 1)));
    const uint32_t entry = clusters.clusters[(z * clusters.tilesY + y) * clusters.tilesX + x];
    const auto first = clusters.indices.begin() + (entry >> LightClusters::kCountBits);
    return {first, first + (entry & LightClusters::kMaxPerCluster)};
}

std::vector<PunctualLight> randomLights(Random& random, uint32_t count) {
    std::vector<PunctualLight> lights(count);
    for (PunctualLight& light : lights) {
        light.position = random.vector(-20, 20);
        light.intensity = vec3(random.uniform(0.001f, 0.05f));
        light.range = random.below(4) == 0 ? 0 : random.uniform(0.2f, 8);
        light.direction = random.direction();
        if (random.below(3) == 0) {
            light.outerConeAngle = random.uniform(0.1f, 1.5f);
            light.innerConeAngle = light.outerConeAngle * 0.5f;
        }
    }
    return lights;
}

TEST(LightClusters, EveryLightThatReachesAPointIsInItsFroxel) {
    Random random(7);
    size_t listed = 0, reaching = 0;
    for (int trial = 0; trial < 40; ++trial) {
        const bool perspective = trial % 2 == 0;
        const vec3 eye = random.vector(-15, 15);
        const CameraMatrices camera = cameraAt(eye, eye + random.direction(), perspective);
        const std::vector<PunctualLight> lights = randomLights(random, 60);
        LightClusters clusters;
        clusters.build(camera, kWidth, kHeight, {lights, {}, {}}, jobs);
        ASSERT_EQ(clusters.droppedReferences, 0u);
        ASSERT_EQ(clusters.lights.size(), clusters.visibleLights);
        for (int i = 0; i < 400; ++i) {
            const vec2 uv(random.uniform(0, 0.9999f), random.uniform(0, 0.9999f));
            const float depth = perspective ? std::exp2(random.uniform(-3.3f, 5.5f))
                                            : random.uniform(-10, 45);
            const vec3 relative = camera.relativePosition(uv, depth);
            const std::vector<uint16_t> list = listAt(clusters, uv, depth);
            EXPECT_TRUE(std::ranges::is_sorted(list));
            listed += list.size();
            for (const PunctualLight& light : lights) {
                const vec3 position = light.position - camera.position;
                if (glm::distance(position, relative) > effectiveRange(light) * 0.999f) continue;
                const float cosine = glm::dot(glm::normalize(relative - position), light.direction);
                if (light.outerConeAngle >= 0 && cosine < std::cos(light.outerConeAngle)) continue;
                ++reaching;
                const bool found = std::ranges::any_of(
                    list, [&](uint16_t l) { return clusters.lights[l].position == position; });
                EXPECT_TRUE(found) << "trial " << trial << ", depth " << depth << ", range "
                                   << effectiveRange(light);
            }
        }
    }
    EXPECT_LT(double(listed), 3.6 * double(reaching))
        << "lists hold far more than what reaches their froxels";
}

TEST(LightClusters, TheShadowRecordOfNumberZeroIsOne) {
    const CameraMatrices camera = cameraAt({0, 0, 0}, {0, 0, -1}, true);
    std::vector<PunctualLight> lights(3);
    for (PunctualLight& light : lights) light.position = {0, 0, -3}, light.range = 1;
    const int32_t records[] = {-1, 0, 12};
    ClusterInputs inputs;
    inputs.punctual = lights;
    inputs.shadowRecords = records;
    LightClusters clusters;
    clusters.build(camera, kWidth, kHeight, inputs, jobs);
    EXPECT_EQ(clusters.visibleOfClass[size_t(LightClass::plain)], 1u);
    EXPECT_EQ(clusters.visibleOfClass[size_t(LightClass::modulated)], 2u);
}

TEST(LightClusters, AOneSidedAreaLightIsListedBeforeItsPlaneAlone) {
    const CameraMatrices camera = cameraAt({0, 0, 0}, {0, 0, -1}, true);
    AreaLight light;  // looks along +x
    light.position = {0, 0, -8};
    light.halfX = {0, 0.5f, 0};
    light.halfY = {0, 0, 0.5f};
    light.range = 3;
    LightClusters clusters;
    const auto listed = [&](const vec3& p) {
        const vec2 uv(0.5f + 0.5f * p.x / (-p.z * camera.tanHalfX),
                      0.5f + 0.5f * p.y / (-p.z * camera.tanHalfY));
        const float slice = std::log2(-p.z) * clusters.sliceScale + clusters.sliceBias;
        const uint32_t froxel = (uint32_t(slice) * clusters.tilesY +
                                 uint32_t(uv.y * kHeight) / clusters.tilePixels) *
                                    clusters.tilesX +
                                uint32_t(uv.x * kWidth) / clusters.tilePixels;
        return clusters.clusters[froxel * 2 + 1] >> LightClusters::kCountBits;
    };
    clusters.build(camera, kWidth, kHeight, {{}, {}, {&light, 1}}, jobs);
    ASSERT_EQ(clusters.visibleOfClass[size_t(LightClass::area)], 1u);
    ASSERT_EQ(clusters.recordWords, 2u);
    EXPECT_EQ(listed({2, 0, -8}), 1u);
    EXPECT_EQ(listed({-2, 0, -8}), 0u);
    light.twoSided = true;
    clusters.build(camera, kWidth, kHeight, {{}, {}, {&light, 1}}, jobs);
    EXPECT_EQ(listed({-2, 0, -8}), 1u);
    const auto slots = std::bit_cast<GpuAreaLight>(
        std::array{clusters.lights[0], clusters.lights[1]});
    EXPECT_EQ(slots.position, light.position);
    EXPECT_EQ(slots.twoSided, 1);
}

// Lights with a shadow record stand after the plain ones, in two slots each, and are counted in a
// word of their own.
TEST(LightClusters, ClassesAreListedApart) {
    Random random(3);
    const CameraMatrices camera = cameraAt({0, 0, 22}, {0, 0, 0}, true);
    const std::vector<PunctualLight> lights = randomLights(random, 80);
    std::vector<int32_t> records(lights.size());
    for (size_t i = 0; i < records.size(); ++i) records[i] = i % 3 == 0 ? int32_t(i) : -1;
    LightClusters plain, mixed;
    plain.build(camera, kWidth, kHeight, {lights, {}, {}}, jobs);
    mixed.build(camera, kWidth, kHeight, {lights, records, {}}, jobs);
    EXPECT_EQ(plain.recordWords, 1u);
    ASSERT_EQ(mixed.recordWords, 2u);
    EXPECT_EQ(plain.visibleLights, mixed.visibleLights);
    EXPECT_EQ(plain.indices.size(), mixed.indices.size());
    const uint32_t plainLights = mixed.visibleOfClass[size_t(LightClass::plain)];
    EXPECT_EQ(mixed.lights.size(),
              plainLights + 2 * mixed.visibleOfClass[size_t(LightClass::modulated)]);
    size_t modulated = 0;
    for (size_t f = 0; f < plain.clusters.size(); ++f) {
        const uint32_t* record = &mixed.clusters[2 * f];
        const uint32_t counts[] = {record[0] & LightClusters::kMaxPerCluster,
                                   record[1] & LightClusters::kMaxPerCluster};
        ASSERT_EQ(counts[0] + counts[1], plain.clusters[f] & LightClusters::kMaxPerCluster);
        const uint32_t first = record[0] >> LightClusters::kCountBits;
        for (uint32_t i = 0; i < counts[0]; ++i) EXPECT_LT(mixed.indices[first + i], plainLights);
        for (uint32_t i = counts[0]; i < counts[0] + counts[1]; ++i) {
            const uint16_t slot = mixed.indices[first + i];
            ASSERT_GE(slot, plainLights);
            ASSERT_EQ((slot - plainLights) % 2, 0u);
            const auto modulation = std::bit_cast<GpuLightModulation>(mixed.lights[slot + 1u]);
            const auto index = size_t(modulation.shadowRecord);
            ASSERT_LT(index, lights.size());
            EXPECT_EQ(index % 3, 0u);
            EXPECT_EQ(mixed.lights[slot].position, lights[index].position - camera.position);
            ++modulated;
        }
    }
    EXPECT_GT(modulated, 100u);
}

TEST(LightClusters, LightsOutOfSightAreLeftOut) {
    const CameraMatrices camera = cameraAt({0, 0, 0}, {0, 0, -1}, true);
    PunctualLight behind, beside, before;
    behind.position = {0, 0, 10};
    beside.position = {30, 0, -5};
    before.position = {0, 0, -5};
    behind.range = beside.range = before.range = 2;
    LightClusters clusters;
    clusters.build(camera, kWidth, kHeight, {std::array{behind, beside, before}, {}, {}}, jobs);
    EXPECT_EQ(clusters.visibleLights, 1u);
    EXPECT_EQ(clusters.lights[0].position, before.position);
    clusters.build(camera, kWidth, kHeight, {std::array{behind, beside}, {}, {}}, jobs);
    EXPECT_EQ(clusters.visibleLights, 0u);
    EXPECT_EQ(clusters.clusters.size(),
              size_t(clusters.tilesX) * clusters.tilesY * clusters.slices);
    EXPECT_TRUE(std::ranges::all_of(clusters.clusters, [](uint32_t c) { return c == 0; }));
}

TEST(LightClusters, AnUnboundedLightReachesToAThousandthOfALux) {
    PunctualLight light;
    light.intensity = {10, 40, 2};
    EXPECT_FLOAT_EQ(effectiveRange(light), std::sqrt(40 / 1e-3f));
    light.range = 3;
    EXPECT_FLOAT_EQ(effectiveRange(light), 3);
}

// KHR_lights_punctual: full inside of the inner cone, none outside of the outer one.
TEST(LightClusters, SpotFalloffRunsFromConeToCone) {
    const CameraMatrices camera = cameraAt({1, 2, 3}, {1, 2, -1}, true);
    PunctualLight spot, point;
    spot.position = point.position = {1, 2, 0};
    spot.range = point.range = 4;
    spot.innerConeAngle = 0.3f;
    spot.outerConeAngle = 0.8f;
    LightClusters clusters;
    clusters.build(camera, kWidth, kHeight, {std::array{spot, point}, {}, {}}, jobs);
    ASSERT_EQ(clusters.visibleLights, 2u);
    const auto falloff = [&](const GpuLight& light, float angle) {
        const float f = std::clamp(std::cos(angle) * light.spotScale + light.spotOffset, 0.0f,
                                   1.0f);
        return f * f;
    };
    EXPECT_NEAR(falloff(clusters.lights[0], 0.3f), 1, 1e-4f);
    EXPECT_FLOAT_EQ(falloff(clusters.lights[0], 0.1f), 1);
    EXPECT_NEAR(falloff(clusters.lights[0], 0.8f), 0, 1e-6f);
    EXPECT_FLOAT_EQ(falloff(clusters.lights[0], 1.2f), 0);
    EXPECT_FLOAT_EQ(falloff(clusters.lights[1], 3), 1);
    EXPECT_FLOAT_EQ(clusters.lights[0].inverseRangeSq, 1 / 16.0f);
    EXPECT_EQ(clusters.lights[0].position, vec3(0, 0, -3));
}

TEST(LightClusters, AFullFroxelDropsAndCounts) {
    const CameraMatrices camera = cameraAt({0, 0, 0}, {0, 0, -1}, true);
    std::vector<PunctualLight> lights(1100);
    for (PunctualLight& light : lights) {
        light.position = {0.01f, 0.01f, -5};
        light.range = 0.05f;
    }
    LightClusters clusters;
    clusters.build(camera, kWidth, kHeight, {lights, {}, {}}, jobs);
    EXPECT_EQ(clusters.visibleLights, 1100u);
    const vec2 middle(0.5f + 0.01f / 5, 0.5f + 0.01f / 5);
    const std::vector<uint16_t> list = listAt(clusters, middle, 5);
    EXPECT_EQ(list.size(), LightClusters::kMaxPerCluster);
    uint32_t kept = 0;
    for (uint32_t cluster : clusters.clusters) kept += cluster & LightClusters::kMaxPerCluster;
    EXPECT_EQ(kept, clusters.indices.size());
    EXPECT_GE(clusters.droppedReferences, 1100u - 1023);
    EXPECT_EQ(clusters.droppedReferences % (1100 - 1023), 0u);
}

// A froxel's first index has 22 bits: the lists of many lights that reach everywhere do not fit at
// 4K.
TEST(LightClusters, ListsThatDoNotFitAreDroppedAndCounted) {
    View view;
    const CameraMatrices camera = makeCamera(view, 3840.0f / 2160).value();
    std::vector<PunctualLight> lights(200);
    for (PunctualLight& light : lights) {
        light.position = {0, 0, -5};
        light.intensity = vec3(1e6f);
    }
    LightClusters clusters;
    clusters.build(camera, 3840, 2160, {lights, {}, {}}, jobs);
    EXPECT_LE(clusters.indices.size(), size_t(LightClusters::kMaxReferences));
    uint64_t kept = 0;
    for (uint32_t cluster : clusters.clusters) {
        const uint32_t count = cluster & LightClusters::kMaxPerCluster;
        ASSERT_LE((cluster >> LightClusters::kCountBits) + count, clusters.indices.size());
        ASSERT_EQ(cluster >> LightClusters::kCountBits, kept);
        kept += count;
    }
    EXPECT_EQ(kept, clusters.indices.size());
    const uint32_t least = std::ranges::min(
        clusters.clusters, {}, [](uint32_t c) { return c & LightClusters::kMaxPerCluster; });
    EXPECT_GT(least & LightClusters::kMaxPerCluster, 60u)
        << "some froxel lost far more than its share";
    EXPECT_EQ(kept + clusters.droppedReferences,
              uint64_t(clusters.clusters.size()) * lights.size());
}

}  // namespace
}  // namespace rushlight

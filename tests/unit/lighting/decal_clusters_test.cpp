#include "renderer/lighting/clusters/decal_clusters.h"

#include "renderer/backend/null/null_device.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace rushlight {
namespace {

constexpr uint32_t kWidth = 700, kHeight = 450;  // neither is a multiple of a tile

struct Fixture {
    std::unique_ptr<Device> device = createNullDevice();
    DecalStore store{*device};
    DecalMaterialHandle material = *store.create({.label = "paint"});
};

/// Found as shaders/common/surface/decals.glsl finds it.
std::vector<uint32_t> listAt(const DecalClusters& clusters, vec2 uv, float viewDepth) {
    const uint32_t x = uint32_t(uv.x * kWidth) / RL_DECAL_PIXELS;
    const uint32_t y = uint32_t(uv.y * kHeight) / RL_DECAL_PIXELS;
    const float slice = std::log2(std::max(viewDepth, 1e-6f)) * clusters.sliceScale +
                        clusters.sliceBias;
    const uint32_t z = uint32_t(std::clamp(slice, 0.0f, float(DecalClusters::kSlices - 1)));
    const uint32_t record = clusters.lists[(z * clusters.tilesY + y) * clusters.tilesX + x];
    const auto first = clusters.lists.begin() + (record >> 8);
    return {first, first + (record & 255)};
}

Decal randomDecal(Random& random, DecalMaterialHandle material) {
    Decal decal;
    decal.material = material;
    const mat3 turn(glm::rotate(mat4(1), random.uniform(0, 6), random.direction()));
    for (int c = 0; c < 3; ++c) decal.worldFromDecal[c] = turn[c] * random.uniform(0.05f, 2);
    decal.worldFromDecal[3] = random.vector(-12, 12);
    return decal;
}

TEST(DecalClusters, EveryDecalThatHoldsAPointIsInItsFroxelInOrder) {
    Fixture f;
    Random random(11);
    size_t found = 0, listed = 0, possible = 0;
    for (int trial = 0; trial < 30; ++trial) {
        View view;
        const vec3 eye = random.vector(-10, 10);
        view.viewFromWorld = glm::lookAt(eye, eye + random.direction(), vec3(0, 1, 0));
        view.perspective = trial % 3 != 0;
        view.orthoHalfHeight = 8;
        view.nearPlane = view.perspective ? 0.1f : -10;
        view.farPlane = view.perspective ? 0 : 60;
        const CameraMatrices camera = makeCamera(view, float(kWidth) / kHeight).value();
        std::vector<Decal> decals(50);
        for (Decal& d : decals) d = randomDecal(random, f.material);
        DecalClusters clusters;
        clusters.build(camera, kWidth, kHeight, decals, f.store);
        for (int i = 0; i < 3000; ++i) {
            const Decal& d = decals[random.below(50)];
            const vec3 point = d.worldFromDecal * vec4(random.vector(-1, 1), 1);
            const vec4 clip = camera.clipFromWorld * vec4(point, 1);
            const vec2 uv = vec2(clip) / clip.w * 0.5f + 0.5f;
            const float depth = glm::dot(point - camera.position, camera.forward);
            const bool seen = uv.x > 0 && uv.x < 1 && uv.y > 0 && uv.y < 1 &&
                              depth > camera.nearPlane;
            if (!seen) continue;
            const std::vector<uint32_t> list = listAt(clusters, uv, depth);
            EXPECT_TRUE(std::ranges::is_sorted(list));
            listed += list.size();
            possible += clusters.decals.size();
            for (uint32_t k = 0; k < clusters.decals.size(); ++k) {
                const GpuDecal& g = clusters.decals[k];
                const vec4 relative(point - camera.position, 1);
                bool inside = true;
                for (int row = 0; row < 3; ++row)
                    inside = inside && std::abs(glm::dot(g.rows[row], relative)) <= 0.999f;
                if (!inside) continue;
                ++found;
                EXPECT_TRUE(std::ranges::find(list, k) != list.end());
            }
        }
    }
    EXPECT_GT(found, 5000u);
    EXPECT_LT(listed, possible / 3);
}

TEST(DecalClusters, WhatCannotBeDrawnIsLeftOut) {
    Fixture f;
    const CameraMatrices camera = makeCamera(View{}, 1.5f).value();
    Decal good;
    good.material = f.material;
    good.worldFromDecal[3] = {0, 0, -5};
    Decal flat = good, lost = good, broken = good, stale = good;
    flat.worldFromDecal[2] = vec3(0);
    lost.worldFromDecal[3].z = std::numeric_limits<float>::quiet_NaN();
    broken.worldFromDecal[0].x = std::numeric_limits<float>::infinity();
    stale.material = *f.store.create({.label = "gone"});
    f.store.destroy(stale.material);
    const Decal all[] = {flat, lost, broken, stale, good};
    DecalClusters clusters;
    clusters.build(camera, kWidth, kHeight, all, f.store);
    EXPECT_EQ(clusters.decals.size(), 1u);
    clusters.build(camera, kWidth, kHeight, {}, f.store);
    EXPECT_EQ(std::ranges::count(clusters.lists, 0u), int64_t(clusters.lists.size()));
}

TEST(DecalStore, RefusesBadPicturesAndTooMany) {
    Fixture f;
    const std::vector<uint8_t> pixels(4 * 4 * 4, 200);
    DecalMaterialDesc desc{.label = "x",
                           .baseColor = {.label = "x", .width = 4, .height = 4, .pixels = pixels}};
    EXPECT_TRUE(f.store.create(desc));
    desc.baseColor.width = 5;
    const auto wrong = f.store.create(desc);
    ASSERT_FALSE(wrong);
    EXPECT_NE(wrong.error().text().find("5x4"), std::string::npos) << wrong.error().text();
    DecalMaterialHandle last;
    for (uint32_t i = 2; i < kMaxDecalMaterials; ++i) last = *f.store.create({.label = "y"});
    EXPECT_FALSE(f.store.create({.label = "z"}));
    f.store.destroy(last);
    EXPECT_TRUE(f.store.create({.label = "z"}));
}

}  // namespace
}  // namespace rushlight

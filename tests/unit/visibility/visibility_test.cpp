#include "renderer/visibility/visibility.h"

#include "tests/support/memory_device.h"
#include "tests/support/random.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/thread_jobs.h"

#include <gtest/gtest.h>

namespace rushlight {
namespace {

class VisibilityTest : public testing::Test {
protected:
    MemoryDevice device;
    SerialJobs jobs;
    GeometryStore geometry{device};
    TextureStore textures{device, jobs};
    MaterialStore materials{device, textures};
    Shape ballShape = makeSphere(24, 48);
    MeshHandle cube = *geometry.create(makeCube().desc());
    MeshHandle ball = *geometry.create(ballShape.desc());
    std::vector<Instance> instances;
    InstanceWorld world;
    Visibility visibility;
    Visibility::Lists lists;
    LodMemory lods;
    FrameSettings settings;

    Instance& add(MeshHandle mesh, const vec3& at, float scale = 1) {
        Instance instance;
        instance.mesh = mesh;
        instance.worldFromLocal = mat4x3(scale);
        instance.worldFromLocal[3] = at;
        instances.push_back(instance);
        return instances.back();
    }
    Visibility::Counts gather(JobSystem* with = nullptr) {
        EXPECT_TRUE(materials.flush(*textures.flush()));
        world.noteChanges(geometry.changedMeshes(), materials.changedMaterials());
        visibility.noteChanges(geometry.changedMeshes());
        geometry.clearChanges();
        materials.clearChanges();
        world.assign(instances, jobs);
        world.prepare(geometry, materials, {}, jobs);
        const CameraMatrices camera = makeCamera({}, 16.0f / 9).value();
        const ShadowCascades cascades = makeShadowCascades(
            camera, {glm::normalize(vec3(-1, -2, -1)), 3, 512, 0, world.bounds()});
        lods.begin({});
        const Visibility::Counts counts = visibility.gather(
            {{{nullptr, &world}}, &geometry, &camera, 1280, 720, &settings, &cascades, &lods},
            with ? *with : jobs, lists);
        lods.commit();
        return counts;
    }
    uint32_t lodAt(float distance) {
        instances.clear();
        add(ball, {0, 0, -distance});
        gather();
        return lists.opaque.items.at(0).lod;
    }
};

TEST_F(VisibilityTest, TheLevelOfDetailFallsWithTheDistanceAndKeepsItsError) {
    const GpuMesh& mesh = *geometry.find(ball);
    ASSERT_GE(mesh.lodCount, 4u);
    const float pixelsPerMetre = 720 / (2 * std::tan(0.785f / 2));
    settings.smallObjectPixels = 0;
    for (const float allowed : {settings.lodPixelError, 20.0f}) {  // far from the eye, and near
        settings.lodPixelError = allowed;
        uint32_t last = 0;
        for (float distance = 2; distance < 3000; distance *= 1.05f) {
            const uint32_t lod = lodAt(distance);
            const float pixels = pixelsPerMetre / (distance - std::sqrt(3.0f));
            EXPECT_LE(mesh.lods[lod].error * pixels, allowed * 1.001f);
            EXPECT_GE(lod, last);
            last = lod;
        }
        EXPECT_EQ(last, mesh.lodCount - 1);
    }
    settings.lodPixelError = 0;
    EXPECT_EQ(lodAt(1000), 0u);
}

TEST_F(VisibilityTest, LargerCopiesAreMoreDetailed) {
    add(ball, {-30, 0, -120}, 0.3f);
    add(ball, {30, 0, -120}, 20);
    gather();
    ASSERT_EQ(lists.opaque.items.size(), 2u);
    const bool firstIsSmall = (lists.opaque.items[0].object & 1) == 0;
    EXPECT_GT(lists.opaque.items[!firstIsSmall].lod, lists.opaque.items[firstIsSmall].lod);
}

// Going back and forth over a switching distance by less than the margin changes the level once at
// most.
TEST_F(VisibilityTest, NearASwitchTheLevelStays) {
    const GpuMesh& mesh = *geometry.find(ball);
    add(ball, {0, 0, -10});
    const float pixelsPerMetre = 720 / (2 * std::tan(0.785f / 2));
    const float limit = mesh.lods[2].error * pixelsPerMetre / settings.lodPixelError +
                        std::sqrt(3.0f);
    uint32_t changes = 0, last = 0;
    for (int i = 0; i < 40; ++i) {
        instances[0].worldFromLocal[3].z = -limit * (i % 2 ? 1.02f : 0.98f);
        gather();
        const uint32_t lod = lists.opaque.items.at(0).lod;
        changes += i > 0 && lod != last;
        last = lod;
    }
    EXPECT_LE(changes, 1u);
}

TEST_F(VisibilityTest, WhatIsSmallerThanAPixelIsLeftOut) {
    add(cube, {0, 0, -50}, 0.01f);
    add(cube, {1, 0, -50}, 0.05f);
    add(cube, {-1, 0, -50}, 0.025f);  // 1.5 pixels across, corner to corner; half of that from its
                                      // middle
    const Visibility::Counts counts = gather();
    EXPECT_EQ(counts.culledSmall, 1u);
    EXPECT_EQ(counts.visible, 2u);
    settings.smallObjectPixels = 0;
    EXPECT_EQ(gather().visible, 3u);
}

TEST_F(VisibilityTest, AWallHidesWhatIsBehindIt) {
    add(cube, {0, 0, -10}).worldFromLocal[0].x = 8;
    instances[0].worldFromLocal[1].y = 8;
    for (int i = 0; i < 40; ++i) add(cube, {float(i % 8) - 4, float(i / 8) - 2, -30}, 0.4f);
    for (int i = 0; i < 10; ++i) add(cube, {float(i) - 5, 0, -5}, 0.2f);
    const Visibility::Counts counts = gather();
    EXPECT_EQ(counts.culledOcclusion, 40u);
    EXPECT_EQ(counts.visible, 10u) << "one of ten before it is out of the view";
    settings.occlusionCulling = false;
    EXPECT_EQ(gather().visible, 50u);
}

TEST_F(VisibilityTest, ContentSaysWhatHidesAndWhatDoesNot) {
    add(cube, {0, 0, -10}, 0.2f);
    for (int i = 0; i < 30; ++i) add(cube, {0.01f * float(i % 6), 0, -11 - 0.1f * float(i)}, 0.05f);
    EXPECT_EQ(gather().culledOcclusion, 0u) << "too small to be considered";
    instances[0].flags |= kInstanceOccluder;
    EXPECT_EQ(gather().culledOcclusion, 30u);
    instances[0].worldFromLocal = mat4x3(4.0f);
    instances[0].worldFromLocal[3] = {0, 0, -20};
    instances[0].flags = kInstanceCastsShadow;
    for (int i = 1; i <= 30; ++i) instances[size_t(i)].worldFromLocal[3].z = -40;
    EXPECT_EQ(gather().culledOcclusion, 30u);
    instances[0].flags |= kInstanceNoOccluder;
    EXPECT_EQ(gather().culledOcclusion, 0u);
}

// A hidden caster still casts: its shadow may fall where it is not.
TEST_F(VisibilityTest, HiddenCastersStillCast) {
    add(cube, {0, 0, -10}, 8);
    for (int i = 0; i < 40; ++i) add(cube, {float(i % 8) - 4, float(i / 8) - 2, -30}, 0.4f);
    settings.smallObjectPixels = 0;
    gather();
    size_t casters = 0;
    for (const DrawList& list : lists.casters) casters += list.items.size();
    EXPECT_GE(casters, 41u);
}

TEST_F(VisibilityTest, AnyNumberOfThreadsFindsTheSame) {
    Random random(7);
    for (int i = 0; i < 6000; ++i)
        add(i % 2 ? cube : ball, random.vector(-60, 60), random.uniform(0.05f, 2));
    gather();
    const auto all = [&] {
        std::vector<uint64_t> keys;
        for (const DrawList* list :
             {&lists.opaque, &lists.casters[0], &lists.casters[1], &lists.casters[2]})
            for (const VisibleItem& item : list->items) {
                keys.push_back(item.key);
                keys.push_back(uint64_t(item.object) << 32 | item.lod);
            }
        return keys;
    };
    const auto alone = all();
    EXPECT_GT(alone.size(), 2000u);
    for (uint32_t threads : {2u, 4u, 8u}) {
        ThreadJobs several(threads);
        gather(&several);
        EXPECT_TRUE(all() == alone) << threads;
    }
}

}  // namespace
}  // namespace rushlight

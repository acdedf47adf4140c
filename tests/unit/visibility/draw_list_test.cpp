#include "renderer/visibility/visibility.h"

#include "renderer/materials/surface_variant.h"
#include "tests/support/memory_device.h"
#include "tests/support/random.h"
#include "tests/support/scenes/shapes.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <tuple>

namespace rushlight {
namespace {

class DrawListTest : public testing::Test {
protected:
    MemoryDevice device;
    SerialJobs jobs;
    GeometryStore geometry{device};
    TextureStore textures{device, jobs};
    MaterialStore materials{device, textures};
    MeshHandle cube = *geometry.create(makeCube().desc());
    MeshHandle ball = *geometry.create(makeSphere(4, 6).desc());
    MeshHandle sheet = *geometry.create(makeCube(1).desc());
    std::vector<Instance> instances;
    std::vector<mat4x3> previous;
    InstanceWorld world;
    Visibility visibility;
    Visibility::Lists lists;
    CommandBuffer buffer;

    MaterialHandle material(void (*change)(MaterialDesc&)) {
        MaterialDesc desc;
        change(desc);
        return *materials.create(desc);
    }
    Instance& add(MeshHandle mesh, MaterialHandle m, float distance) {
        Instance instance;
        instance.mesh = mesh;
        instance.material = m;
        instance.worldFromLocal[3] = {0, 0, -distance};
        instance.id = 100 + uint32_t(instances.size());
        instances.push_back(instance);
        return instances.back();
    }
    /// From the origin along -z, one shadow view from above, without culling unless asked for.
    void build(bool cull = false) {
        ASSERT_TRUE(materials.flush(*textures.flush()));
        world.noteChanges(geometry.changedMeshes(), materials.changedMaterials());
        geometry.clearChanges();
        materials.clearChanges();
        world.assign(instances, jobs);
        world.prepare(geometry, materials, previous, jobs);
        const CameraMatrices camera = makeCamera({}, 1).value();
        FrameSettings settings;
        settings.frustumCulling = cull;
        settings.smallObjectPixels = 0;
        settings.occlusionCulling = false;
        const ShadowCascades cascades = makeShadowCascades(
            camera, {vec3(0, -1, 0), 1, 256, 0, Aabb{vec3(-20), vec3(20)}});
        LodMemory lods;
        Visibility::Inputs in{{{nullptr, &world}}, &geometry, &camera, 100, 100,
                              &settings,           &cascades, &lods};
        visibility.gather(in, jobs, lists);
        buffer.clear();
        for (DrawList* list : {&lists.opaque, &lists.blended, &lists.movingEmission, &shadow()}) {
            list->allocate(buffer);
            list->fill(buffer, in.worlds, 0, uint32_t(list->items.size()));
        }
    }
    DrawList& shadow() { return lists.casters[0]; }
    static std::vector<uint32_t> order(const DrawList& list) {
        std::vector<uint32_t> seen;
        for (const VisibleItem& item : list.items) seen.push_back(item.object & 0x7fffffff);
        return seen;
    }
    template <class T>
    T data(const BufferRange& range, size_t index) {
        T value;
        std::memcpy(static_cast<void*>(&value), buffer.bytes(range).data() + index * sizeof(T),
                    sizeof(T));
        return value;
    }
};
using Order = std::vector<uint32_t>;

TEST_F(DrawListTest, OpaqueIsSortedByStateThenFrontToBack) {
    const MaterialHandle plain = material([](MaterialDesc&) {});
    const MaterialHandle masked = material([](MaterialDesc& d) { d.alphaMode = AlphaMode::mask; });
    for (float distance : {8.0f, 2.0f, 32.0f}) {
        add(cube, masked, distance);
        add(cube, plain, distance);
    }
    build();
    EXPECT_EQ(order(lists.opaque), (Order{3, 1, 5, 2, 0, 4}))
        << "plain before masked, each near to far";
    ASSERT_EQ(lists.opaque.batches.size(), 2u);
    EXPECT_FALSE(lists.opaque.batches[0].surfaceFlags & kAlphaMask);
    EXPECT_TRUE(lists.opaque.batches[1].surfaceFlags & kAlphaMask);
}

TEST_F(DrawListTest, BlendedIsBackToFrontWhateverTheState) {
    const MaterialHandle a = material([](MaterialDesc& d) { d.alphaMode = AlphaMode::blend; });
    const MaterialHandle b = material([](MaterialDesc& d) {
        d.alphaMode = AlphaMode::blend;
        d.doubleSided = true;
    });
    add(cube, a, 3), add(ball, b, 9), add(cube, b, 5), add(ball, a, 7), add(cube, {}, 6);
    build();
    EXPECT_EQ(order(lists.blended), (Order{1, 3, 2, 0}));
    EXPECT_EQ(lists.blended.batches.size(), 4u);

    EXPECT_EQ(order(lists.opaque), (Order{4}));
}

TEST_F(DrawListTest, TiesKeepTheCallersOrder) {
    const MaterialHandle glass = material([](MaterialDesc& d) { d.alphaMode = AlphaMode::blend; });
    for (int i = 0; i < 50; ++i) add(cube, glass, 4);
    build();
    for (uint32_t i = 0; i < 50; ++i) EXPECT_EQ(order(lists.blended)[i], i);
}

TEST_F(DrawListTest, EqualMeshesMergeIntoOneInstancedDraw) {
    for (int i = 0; i < 5; ++i) add(cube, {}, 4.0f + 0.001f * float(i));
    for (int i = 0; i < 3; ++i) add(ball, {}, 4.0f);
    build();
    ASSERT_EQ(lists.opaque.batches.size(), 1u);
    EXPECT_EQ(lists.opaque.batches[0].drawCount, 2u);
    const auto first = data<DrawIndexedCommand>(lists.opaque.commandRange, 0);
    const auto second = data<DrawIndexedCommand>(lists.opaque.commandRange, 1);
    const GpuMesh& c = *geometry.find(cube);
    const GpuMesh& b = *geometry.find(ball);
    EXPECT_EQ(first.instanceCount, 5u);
    EXPECT_EQ(first.indexCount, c.indexCount);
    EXPECT_EQ(first.baseVertex, int32_t(c.firstVertex));
    EXPECT_EQ(first.baseInstance, 0u);
    EXPECT_EQ(second.instanceCount, 3u);
    EXPECT_EQ(second.firstIndex, b.firstIndex);
    EXPECT_EQ(second.baseInstance, 5u);
    EXPECT_EQ(lists.opaque.batches[0].triangleCount, (5 * c.indexCount + 3 * b.indexCount) / 3);
    for (uint32_t i = 0; i < 5; ++i)
        EXPECT_EQ(data<InstanceData>(lists.opaque.instanceRange, i).id, 100 + i);
}

// Of large meshes only what may face the view is drawn, where backs are culled at all.
TEST_F(DrawListTest, BacksAreLeftOutWhereTheyAreCulled) {
    const Shape shape = makeSphere(14, 21);
    MeshDesc desc = shape.desc();
    desc.lods = false;
    const MeshHandle large = *geometry.create(desc);
    const uint32_t all = geometry.find(large)->indexCount / 3;
    const auto drawn = [&](const DrawList& list) {
        uint32_t triangles = 0, counted = 0;
        for (const DrawBatch& batch : list.batches) {
            counted += batch.triangleCount;
            for (uint32_t d = 0; d < batch.drawCount; ++d) {
                const auto draw = data<DrawIndexedCommand>(list.commandRange, batch.firstDraw + d);
                triangles += draw.indexCount / 3 * draw.instanceCount;
            }
        }
        EXPECT_EQ(counted, triangles);
        return triangles;
    };
    add(large, {}, 9), add(large, {}, 9);
    build();
    EXPECT_LT(drawn(lists.opaque), 2 * all * 8 / 10);
    EXPECT_EQ(drawn(shadow()), 2 * all);
    for (uint32_t d = 0; d < lists.opaque.batches[0].drawCount; ++d)
        EXPECT_EQ(data<DrawIndexedCommand>(lists.opaque.commandRange, d).instanceCount, 2u);
    instances[1].worldFromLocal[0].x = -1;
    build();
    EXPECT_LT(drawn(lists.opaque), 2 * all * 8 / 10) << "mirrored";

    const MaterialHandle both = material([](MaterialDesc& d) { d.doubleSided = true; });
    const MaterialHandle glass = material([](MaterialDesc& d) { d.alphaMode = AlphaMode::blend; });
    for (Instance& instance : instances) instance.material = both;
    build();
    EXPECT_EQ(drawn(lists.opaque), 2 * all);
    for (Instance& instance : instances) instance.material = glass;
    build();
    EXPECT_EQ(drawn(lists.blended), 2 * all);
    EXPECT_EQ(data<DrawIndexedCommand>(lists.blended.commandRange, 0).firstIndex,
              geometry.find(large)->firstIndex)
        << "in the order that they were given in";
    for (Instance& instance : instances) instance.material = {};
    ASSERT_TRUE(geometry.update(large, desc));
    build();
    EXPECT_EQ(drawn(lists.opaque), 2 * all) << "what was moved may face any way";
}

TEST_F(DrawListTest, InstanceDataHoldsTheTransformByRows) {
    Instance& instance = add(cube, {}, 0);
    instance.worldFromLocal = {1, 2, 3, 4, 5, 6, 7, 8, 10, 11, 12, 13};
    build();
    const auto d = data<InstanceData>(lists.opaque.instanceRange, 0);
    EXPECT_EQ(d.row0, vec4(1, 4, 7, 11));
    EXPECT_EQ(d.row1, vec4(2, 5, 8, 12));
    EXPECT_EQ(d.row2, vec4(3, 6, 10, 13));
}

TEST_F(DrawListTest, MovingInstancesCarryWhereTheyWere) {
    add(cube, {}, 3);
    Instance& moving = add(cube, {}, 4);
    moving.flags |= kInstanceMoving;
    moving.previousTransform = 1;
    previous = {mat4x3(1.0f), mat4x3(2.0f)};
    build();
    ASSERT_EQ(lists.opaque.batches.size(), 2u);
    EXPECT_FALSE(lists.opaque.batches[0].moving);
    EXPECT_TRUE(lists.opaque.batches[1].moving);
    EXPECT_EQ(data<DrawIndexedCommand>(lists.opaque.commandRange, 1).baseInstance, 0u)
        << "a stream of its own";
    const auto d = data<MovingInstanceData>(lists.opaque.movingRange, 0);
    EXPECT_EQ(d.now.id, 101u);
    EXPECT_EQ(d.previousRow1, vec4(0, 2, 0, 0));
}

TEST_F(DrawListTest, MirroredAndDoubleSidedAreToldApart) {
    const MaterialHandle doubleSided = material([](MaterialDesc& d) { d.doubleSided = true; });
    add(cube, {}, 3);
    add(cube, {}, 3).worldFromLocal[0] = {-1, 0, 0};
    add(cube, doubleSided, 3);
    build();
    const uint32_t mask = kMirrored | kDoubleSided;
    EXPECT_EQ(world.record(0).surfaceFlags & mask, 0u);
    EXPECT_EQ(world.record(1).surfaceFlags & mask, uint32_t(kMirrored));
    EXPECT_EQ(world.record(2).surfaceFlags & mask, uint32_t(kDoubleSided));
    EXPECT_EQ(lists.opaque.batches.size(), 3u);
}

// A closed mesh needs no back faces in a shadow map; an open one does. Materials count where alpha
// cuts alone.
TEST_F(DrawListTest, ShadowCastersForgetTheirMaterials) {
    const MaterialHandle red = material([](MaterialDesc& d) { d.emissive = {1, 0, 0}; });
    const MaterialHandle glass = material([](MaterialDesc& d) { d.alphaMode = AlphaMode::blend; });
    const MaterialHandle leaf = material([](MaterialDesc& d) { d.alphaMode = AlphaMode::mask; });
    add(cube, {}, 3), add(cube, red, 4), add(sheet, {}, 3), add(cube, glass, 3), add(cube, leaf, 3);
    add(cube, {}, 5).flags = 0;
    build();
    EXPECT_EQ(shadow().items.size(), 4u);
    ASSERT_EQ(shadow().batches.size(), 3u);
    EXPECT_EQ(shadow().batches[0].surfaceFlags, 0u);
    EXPECT_EQ(data<DrawIndexedCommand>(shadow().commandRange, 0).instanceCount, 2u);
    EXPECT_EQ(shadow().batches[1].surfaceFlags | shadow().batches[2].surfaceFlags,
              uint32_t(kDoubleSided | kAlphaMask));
}

TEST_F(DrawListTest, OnlyMovingEmittersAreInTheirList) {
    const MaterialHandle lamp = material([](MaterialDesc& d) { d.emissive = {1, 1, 1}; });
    previous = {mat4x3(1.0f)};
    add(cube, lamp, 3);
    add(cube, lamp, 3).flags |= kInstanceMoving;
    add(cube, {}, 3).flags |= kInstanceMoving;
    build();
    EXPECT_EQ(order(lists.movingEmission), (Order{1}));
}

TEST_F(DrawListTest, WhatIsOutOfSightIsCulled) {
    add(cube, {}, 5), add(cube, {}, -5);
    add(cube, {}, 5).worldFromLocal[3].x = 50;
    build(true);
    EXPECT_EQ(order(lists.opaque), (Order{0}));
    build();
    EXPECT_EQ(lists.opaque.items.size(), 3u);
}

TEST_F(DrawListTest, BadInstancesAreLeftOut) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const MeshHandle stale = *geometry.create(makeCube().desc());
    geometry.destroy(stale);
    const MaterialHandle gone = material([](MaterialDesc&) {});
    materials.destroy(gone);
    add(cube, {}, 3).worldFromLocal[1].y = nan;
    add(cube, {}, 3).worldFromLocal[3].x = std::numeric_limits<float>::infinity();
    add(stale, {}, 3), add({}, {}, 3), add(cube, gone, 3);
    add(cube, {}, 3).flags |= kInstanceMoving;  // there is no previous transform
    add(cube, {}, 3);
    build();
    EXPECT_EQ(order(lists.opaque), (Order{6}));
    for (uint32_t i = 0; i < 6; ++i) EXPECT_FALSE(world.record(i).valid) << i;
    EXPECT_EQ(world.rejected(), 6u);
}

TEST_F(DrawListTest, TheHashTellsWhatTheListHolds) {
    add(cube, {}, 3), add(ball, {}, 4);
    build();
    const uint64_t before = shadow().contentHash();
    build();
    EXPECT_EQ(shadow().contentHash(), before);
    instances[1].worldFromLocal[3].y += 0.001f;
    build();
    const uint64_t moved = shadow().contentHash();
    EXPECT_NE(moved, before);
    instances[1].mesh = cube;
    build();
    EXPECT_NE(shadow().contentHash(), moved);
}

TEST_F(DrawListTest, AMovingCasterChangesTheHash) {
    previous = {mat4x3(1.0f)};
    const MaterialHandle leaf = material([](MaterialDesc& d) { d.alphaMode = AlphaMode::mask; });
    for (MaterialHandle m : {MaterialHandle{}, leaf}) {
        instances.clear();
        add(cube, m, 3).flags |= kInstanceMoving;
        build();
        const uint64_t before = shadow().contentHash();
        instances[0].worldFromLocal[3].x += 0.01f;
        build();
        EXPECT_NE(shadow().contentHash(), before);
    }
}

TEST_F(DrawListTest, LevelsOfOneMeshAreDrawsOfTheirOwn) {
    const MeshHandle fine = *geometry.create(makeSphere(14, 21).desc());
    const GpuMesh& mesh = *geometry.find(fine);
    ASSERT_GT(mesh.lodCount, 1u);
    for (int i = 0; i < 4; ++i) add(fine, {}, 4);
    build();
    for (size_t i = 2; i < 4; ++i) {
        VisibleItem& item = lists.opaque.items[i];
        item.lod = uint8_t(lists.opaque.items[0].lod ? 0 : 1);
        item.key = opaqueKey(item.flags, 0, fine.index(), item.lod, 4);
    }
    lists.opaque.arrange({{nullptr, &world}}, geometry, {});
    lists.opaque.allocate(buffer);
    ASSERT_EQ(lists.opaque.batches.at(0).drawCount, 2u);
    for (uint32_t i = 0; i < 2; ++i) {
        const auto draw = data<DrawIndexedCommand>(lists.opaque.commandRange, i);
        EXPECT_EQ(draw.instanceCount, 2u);
        EXPECT_EQ(draw.indexCount, mesh.lods[lists.opaque.items[size_t(i) * 2].lod].indexCount);
    }
}

// As drawn above opaqueKey, shadowKey and blendKey: each field decides before those to its right,
// whatever they hold.
TEST(DrawKeys, FieldsDecideInTheirOrder) {
    struct Fields {
        uint32_t flags, set, mesh, lod;
        float depth;
    };
    Random random(5);
    const auto make = [&] {
        const float depths[] = {1, 1.1f, 1.3f, 2, 500};
        // few values, so that fields are often equal; with the highest bit and the lowest
        const auto pick = [&](uint32_t most) {
            return random.below(2) ? most * random.below(2) : random.below(2);
        };
        return Fields{pick(0xffff), pick(0x3ff), pick(0xfffff), pick(7), depths[random.below(5)]};
    };
    // Exponent and two bits.
    const auto coarse = [](float depth) { return std::bit_cast<uint32_t>(depth) >> 21; };
    for (int i = 0; i < 5000; ++i) {
        const Fields a = make(), b = make();
        const auto opaque = [&](const Fields& f) {
            return std::tuple(f.flags, f.set, coarse(f.depth), f.mesh, f.lod, f.depth);
        };
        const auto caster = [](const Fields& f) {
            return std::tuple(f.flags, f.set, f.mesh, f.lod);
        };
        const auto opaqueOf = [](const Fields& f) {
            return opaqueKey(f.flags, f.set, f.mesh, f.lod, f.depth);
        };
        const auto casterOf = [](const Fields& f) {
            return shadowKey(f.flags, f.set, f.mesh, f.lod);
        };
        ASSERT_EQ(opaqueOf(a) < opaqueOf(b), opaque(a) < opaque(b));
        ASSERT_EQ(casterOf(a) < casterOf(b), caster(a) < caster(b));
        ASSERT_EQ(blendKey(a.depth) < blendKey(b.depth), a.depth > b.depth);
    }
}

}  // namespace
}  // namespace rushlight

#include "renderer/visibility/host_worlds.h"

#include "renderer/materials/surface_variant.h"
#include "renderer/visibility/view_motion.h"
#include "tests/support/memory_device.h"
#include "tests/support/random.h"
#include "tests/support/scenes/shapes.h"

#include <gtest/gtest.h>

#include <map>

namespace rushlight {
namespace {

class InstanceWorldTest : public testing::Test {
protected:
    MemoryDevice device;
    SerialJobs jobs;
    GeometryStore geometry{device};
    TextureStore textures{device, jobs};
    MaterialStore materials{device, textures};
    MeshHandle cube = *geometry.create(makeCube().desc());
    HostWorlds worlds;
    WorldHandle handle = worlds.create();
    Random random{1};
    ViewMotion motion;

    Instance at(const vec3& p) const {
        Instance instance;
        instance.mesh = cube;
        instance.worldFromLocal[3] = p;
        return instance;
    }
    InstanceWorld& world() { return *worlds.find(handle); }
    void prepare() {
        EXPECT_TRUE(materials.flush(*textures.flush()));
        world().noteChanges(geometry.changedMeshes(), materials.changedMaterials());
        geometry.clearChanges();
        materials.clearChanges();
        world().prepare(geometry, materials, {}, jobs);
    }
    /// A frame of `motion`'s view.
    void see() {
        prepare();
        motion.begin(handle, &world());
        motion.commit();
    }
    InstanceHandle add(const Instance& instance) {
        InstanceHandle out;
        EXPECT_TRUE(worlds.add(handle, {&instance, 1}, {&out, 1}));
        return out;
    }
    Result<void> update(InstanceHandle which, const Instance& instance) {
        return worlds.update(handle, {&which, 1}, {&instance, 1});
    }
    /// The boxes in both indices, by slot.
    std::map<uint32_t, Aabb> indexed() {
        std::map<uint32_t, Aabb> found;
        for (const SpatialIndex& index : world().indices())
            for (uint32_t p = 0; p < index.positionCount(); ++p)
                if (index.isLive(p)) {
                    EXPECT_TRUE(found.emplace(index.slotAt(p), index.boxAt(p)).second) << "twice";
                }
        return found;
    }
};

TEST_F(InstanceWorldTest, AnUpdateMovesFromWhereTheViewSawIt) {
    const InstanceHandle one = add(at({0, 0, 0})), other = add(at({5, 0, 0}));
    see();
    EXPECT_FALSE(motion.moved(one.index()));
    ASSERT_TRUE(update(one, at({1, 0, 0})));
    ASSERT_TRUE(update(one, at({2, 0, 0})));
    see();
    ASSERT_TRUE(motion.moved(one.index()));
    EXPECT_EQ(motion.previous(one.index())[3], vec3(0)) << "two updates in a frame are one step";
    EXPECT_EQ(world().record(one.index()).center(), vec3(2, 0, 0));
    EXPECT_FALSE(motion.moved(other.index()));
    ASSERT_TRUE(update(one, at({3, 0, 0})));
    see();
    EXPECT_EQ(motion.previous(one.index())[3], vec3(2, 0, 0));
    see();
    EXPECT_FALSE(motion.moved(one.index())) << "it stands still";
}

TEST_F(InstanceWorldTest, EachViewMeasuresFromItsOwnLastFrame) {
    const InstanceHandle one = add(at({0, 0, 0}));
    ViewMotion often, rarely;
    const auto show = [&](ViewMotion& view, bool executed = true) {
        prepare();
        view.begin(handle, &world());
        if (executed) view.commit();
    };
    show(often), show(rarely);
    for (int step = 1; step <= 3; ++step) {
        ASSERT_TRUE(update(one, at({float(step), 0, 0})));
        show(often);
        EXPECT_EQ(often.previous(one.index())[3], vec3(float(step - 1), 0, 0));
    }
    show(rarely, false);
    EXPECT_EQ(rarely.previous(one.index())[3], vec3(0));
    show(rarely);
    EXPECT_EQ(rarely.previous(one.index())[3], vec3(0)) << "the frame before was not executed";
    show(rarely);
    EXPECT_FALSE(rarely.moved(one.index()));
    ViewMotion late;
    show(late);
    EXPECT_FALSE(late.moved(one.index())) << "it never saw it elsewhere";
}

TEST_F(InstanceWorldTest, WhoMissesTooManyMovesFindsAllStanding) {
    const InstanceHandle one = add(at({0, 0, 0}));
    see();
    for (int i = 1; i <= 10000; ++i) ASSERT_TRUE(update(one, at({float(i), 0, 0})));
    EXPECT_LE(world().movesSince(world().moveCount() - 1).size(), 1u);
    EXPECT_TRUE(world().movesSince(0).empty());
    see();
    EXPECT_FALSE(motion.moved(one.index()));
}

TEST_F(InstanceWorldTest, ANewInstanceDoesNotInheritTheMotionOfItsSlot) {
    const InstanceHandle old = add(at({0, 0, 0}));
    see();
    ASSERT_TRUE(update(old, at({1, 0, 0})));
    ASSERT_TRUE(worlds.remove(handle, {&old, 1}));
    Instance fresh = at({5, 0, 0});
    fresh.previousTransform = 77;
    const InstanceHandle one = add(fresh);
    ASSERT_EQ(one.index(), old.index());
    ASSERT_TRUE(update(one, at({6, 0, 0})));
    see();
    ASSERT_TRUE(world().record(one.index()).valid);
    EXPECT_EQ(motion.previous(one.index())[3], vec3(5, 0, 0));
}

TEST_F(InstanceWorldTest, OnlyWhatChangedGetsANewStamp) {
    const InstanceHandle one = add(at({0, 0, 0})), other = add(at({5, 0, 0}));
    prepare();
    const uint32_t before = world().record(one.index()).stamp;
    const uint32_t otherBefore = world().record(other.index()).stamp;
    prepare();
    EXPECT_EQ(world().record(one.index()).stamp, before);
    ASSERT_TRUE(update(one, at({0, 1, 0})));
    prepare();
    EXPECT_NE(world().record(one.index()).stamp, before);
    EXPECT_EQ(world().record(other.index()).stamp, otherBefore);
}

TEST_F(InstanceWorldTest, ChangedMeshesAndMaterialsAreResolvedAgain) {
    MaterialDesc desc;
    const MaterialHandle material = *materials.create(desc);
    Instance instance = at({0, 0, 0});
    instance.material = material;
    const InstanceHandle one = add(instance);
    prepare();
    const InstanceRecord& r = world().record(one.index());
    desc.doubleSided = true;
    ASSERT_TRUE(materials.update(material, desc));
    prepare();
    EXPECT_TRUE(r.surfaceFlags & kDoubleSided);
    Shape large = makeCube();
    for (vec3& p : large.positions) p *= 3.0f;
    ASSERT_TRUE(geometry.update(cube, large.desc()));
    prepare();
    EXPECT_EQ(r.box.high, vec3(3));
    EXPECT_EQ(indexed().at(one.index()).high, vec3(3));
    geometry.destroy(cube);
    prepare();
    EXPECT_FALSE(r.valid);
    EXPECT_EQ(world().rejected(), 1u);
    EXPECT_TRUE(indexed().empty());
}

TEST_F(InstanceWorldTest, StaleHandlesAreRefusedAndNothingIsDone) {
    const InstanceHandle one = add(at({0, 0, 0})), two = add(at({1, 0, 0}));
    ASSERT_TRUE(worlds.remove(handle, {&one, 1}));
    const InstanceHandle both[] = {two, one};
    const Instance moved[] = {at({9, 9, 9}), at({9, 9, 9})};
    EXPECT_FALSE(worlds.update(handle, both, moved));
    EXPECT_FALSE(worlds.remove(handle, both));
    EXPECT_FALSE(worlds.update(handle, {&two, 1}, moved)) << "lengths differ";
    prepare();
    EXPECT_EQ(world().record(two.index()).center(), vec3(1, 0, 0));
    EXPECT_EQ(world().count(), 1u);
    const InstanceHandle three = add(at({2, 0, 0}));
    EXPECT_EQ(three.index(), one.index()) << "its slot is used again";
    EXPECT_FALSE(update(one, moved[0]));
    const InstanceHandle twice[] = {three, three};
    EXPECT_TRUE(worlds.remove(handle, twice));
    EXPECT_EQ(world().count(), 1u);
    worlds.destroy(handle);
    EXPECT_FALSE(update(two, moved[0]));
}

// Any history of adding, moving and removing leaves the indices with exactly what is alive.
TEST_F(InstanceWorldTest, TheIndicesHoldWhatIsAlive) {
    std::map<uint32_t, InstanceHandle> alive;
    std::map<uint32_t, vec3> where;
    const auto put = [&](InstanceHandle instance, const vec3& p) {
        alive[instance.index()] = instance;
        where[instance.index()] = p;
    };
    for (int round = 0; round < 60; ++round) {
        const uint32_t additions = round == 0 ? 500 : random.below(round % 10 ? 20 : 400);
        for (uint32_t i = 0; i < additions; ++i) {
            const vec3 p = random.vector(-50, 50);
            put(add(at(p)), p);
        }
        for (auto& [slot, instance] : std::map(alive)) {
            const uint32_t dice = random.below(20);
            if (dice == 0) {
                ASSERT_TRUE(worlds.remove(handle, {&instance, 1}));
                alive.erase(slot);
                where.erase(slot);
            } else if (dice < 4) {
                const vec3 p = where[slot] + random.vector(-5, 5);
                ASSERT_TRUE(update(instance, at(p)));
                put(instance, p);
            }
        }
        prepare();
        const auto found = indexed();
        ASSERT_EQ(found.size(), alive.size()) << round;
        for (const auto& [slot, box] : found) {
            const vec3 p = where.at(slot);
            EXPECT_EQ(box.low, p - vec3(1));
            EXPECT_EQ(box.high, p + vec3(1));
        }
    }
}

TEST_F(InstanceWorldTest, AssigningTracksTheSpan) {
    InstanceWorld frame;
    std::vector<Instance> instances;
    for (int i = 0; i < 300; ++i) instances.push_back(at(random.vector(-9, 9)));
    EXPECT_TRUE(materials.flush(*textures.flush()));
    const auto sync = [&](std::span<const Instance> span) {
        frame.assign(span, jobs);
        frame.prepare(geometry, materials, {}, jobs);
    };
    sync(instances);
    EXPECT_EQ(frame.count(), 300u);
    const uint32_t stamp = frame.record(7).stamp;
    instances[8].worldFromLocal[3] = vec3(100);
    sync(instances);
    EXPECT_EQ(frame.record(7).stamp, stamp);
    EXPECT_EQ(frame.bounds().high, vec3(101));
    sync(std::span(instances).first(8));
    EXPECT_EQ(frame.count(), 8u);
    EXPECT_EQ(frame.rejected(), 0u);
    EXPECT_LT(frame.bounds().high.x, 20);
    sync(instances);
    EXPECT_EQ(frame.bounds().high, vec3(101));
    instances[8].mesh = {};
    sync(instances);
    EXPECT_EQ(frame.rejected(), 1u);
}

}  // namespace
}  // namespace rushlight

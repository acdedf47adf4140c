#include "renderer/visibility/spatial_index.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <set>

namespace rushlight {
namespace {

Aabb randomBox(Random& random, float reach, float largest) {
    const vec3 center = random.vector(-reach, reach), half = random.vector(0.01f, largest);
    return {center - half, center + half};
}

CullVolume randomVolume(Random& random) {
    View view;
    const vec3 eye = random.vector(-50, 50);
    view.viewFromWorld = glm::lookAt(eye, eye + random.direction(), vec3(0.1f, 1, 0.2f));
    view.verticalFov = random.uniform(0.2f, 1.5f);
    if (random.below(2)) view.farPlane = random.uniform(5, 60);
    CullVolume volume;
    volume.add(makeCamera(view, 1.5f).value().frustum);
    return volume;
}

/// By the definition, in double precision, with its distance from deciding otherwise.
double clearance(const Aabb& box, const CullVolume& volume) {
    double least = 1e30;
    for (uint32_t p = 0; p < volume.count; ++p) {
        double d = volume.planes[p].offset;
        for (int axis = 0; axis < 3; ++axis) {
            const double n = volume.planes[p].normal[axis];
            d += n * (n >= 0 ? box.high[axis] : box.low[axis]);
        }
        least = std::min(least, d);
    }
    return least;
}

TEST(BoxBlock, AgreesWithTheDefinition) {
    Random random(1);
    for (int round = 0; round < 200; ++round) {
        BoxBlock block;
        for (uint32_t i = 0; i < kBlockSize; ++i) block.set(i, randomBox(random, 60, 8));
        const CullVolume volume = randomVolume(random);
        const BlockMasks masks = testBoxes(block, volume);
        EXPECT_EQ(touchingBoxes(block, volume), masks.touching);
        EXPECT_EQ(masks.inside & ~masks.touching, 0u);
        for (uint32_t i = 0; i < kBlockSize; ++i) {
            const double d = clearance(block.get(i), volume);
            EXPECT_TRUE(std::abs(d) < 1e-4 || bool(masks.touching >> i & 1) == (d > 0)) << i;
            Aabb turned = block.get(i);  // inside: the corner that is farthest outwards is in as
                                         // well
            std::swap(turned.low, turned.high);
            const double inner = clearance(turned, volume);
            EXPECT_TRUE(std::abs(inner) < 1e-4 || bool(masks.inside >> i & 1) == (inner > 0)) << i;
        }
    }
}

TEST(BoxBlock, NoPlanesSeeEverything) {
    const BoxBlock block;
    EXPECT_EQ(testBoxes(block, {}).inside, ~uint64_t(0));
}

// Everything that can throw a shadow on a point of the frustum is in the swept volume, and what
// lies behind is not.
TEST(SweptVolume, HoldsWhatCanShadeTheFrustum) {
    Random random(2);
    for (int round = 0; round < 300; ++round) {
        View view;
        view.viewFromWorld = glm::lookAt(random.vector(-5, 5), random.vector(-5, 5),
                                         random.direction());
        const Frustum seen = makeCamera(view, 1.3f).value().frustum;
        const vec3 towardsLight = random.direction();
        CullVolume swept, still;
        addSwept(swept, seen, towardsLight, 0);
        still.add(seen);
        for (int i = 0; i < 100; ++i) {
            const vec3 p = random.vector(-30, 30);
            const bool isSeen = clearance({p, p}, still) > 0;
            const vec3 caster = p + towardsLight * random.uniform(0, 100);
            EXPECT_TRUE(!isSeen || clearance({caster, caster}, swept) > -1e-3) << round;
            // the reverse: walking back from inside of the volume meets the frustum
            if (clearance({p, p}, swept) < 1e-3) continue;
            double from = 0, to = 1e9;
            for (uint32_t k = 0; k < still.count; ++k) {
                const Plane& plane = still.planes[k];
                const double here = glm::dot(plane.normal, p) + plane.offset + 0.01;
                const double along = glm::dot(plane.normal, towardsLight);  // here - t * along >= 0
                if (along > 0)
                    to = std::min(to, here / along);
                else if (along < 0)
                    from = std::max(from, here / along);
            }
            const bool meets = from <= to;
            EXPECT_TRUE(meets) << round << ": the volume is larger than it needs to be";
        }
    }
}

class SpatialIndexTest : public testing::Test {
protected:
    Random random{3};
    SpatialIndex index;
    std::vector<SpatialIndex::Object> objects;

    void fill(uint32_t count, float reach = 100) {
        for (uint32_t i = 0; i < count; ++i)
            objects.push_back({i, randomBox(random, reach, i % 50 ? 1.0f : 30.0f)});
    }
    std::set<uint32_t> seenBy(uint32_t view, std::span<const CullVolume> volumes) const {
        std::vector<SpatialIndex::Visit> visits;
        index.visit(volumes, visits);
        std::set<uint32_t> seen;
        for (const SpatialIndex::Visit& v : visits) {
            if (!(v.touching >> view & 1)) continue;
            uint64_t mask = index.live(v.block);
            if (!(v.inside >> view & 1)) mask &= touchingBoxes(index.boxes(v.block), volumes[view]);
            for (; mask; mask &= mask - 1)
                seen.insert(index.slotAt(v.block * kBlockSize + uint32_t(std::countr_zero(mask))));
        }
        return seen;
    }
    void expectRight(const std::set<uint32_t>& alive) {
        std::vector<CullVolume> volumes;
        for (int v = 0; v < 5; ++v) volumes.push_back(randomVolume(random));
        volumes.push_back({});
        for (uint32_t v = 0; v < volumes.size(); ++v) {
            const std::set<uint32_t> seen = seenBy(v, volumes);
            for (const SpatialIndex::Object& object : objects) {
                const double d = clearance(object.box, volumes[v]);
                const bool expected = alive.contains(object.slot) && d > 0;
                EXPECT_TRUE(seen.contains(object.slot) == expected || std::abs(d) < 1e-3)
                    << object.slot;
            }
        }
    }
};

TEST_F(SpatialIndexTest, FindsWhatAScanFindsAtEverySize) {
    for (uint32_t count : {0u, 1u, 63u, 64u, 65u, 4096u, 4097u, 20000u}) {
        objects.clear();
        fill(count);
        index.build(objects);
        EXPECT_EQ(index.size(), count);
        std::set<uint32_t> alive;
        for (uint32_t i = 0; i < count; ++i) alive.insert(i);
        expectRight(alive);
    }
}

TEST_F(SpatialIndexTest, StaysRightWhileObjectsMoveComeAndGo) {
    fill(3000);
    index.build(objects);
    std::vector<uint32_t> places(3000);
    std::set<uint32_t> alive;
    for (uint32_t p = 0; p < 3000; ++p) places[index.slotAt(p)] = p, alive.insert(p);
    for (int round = 0; round < 12; ++round) {
        for (int i = 0; i < 300; ++i) {
            const uint32_t slot = random.below(uint32_t(objects.size()));
            if (!alive.contains(slot)) continue;
            if (random.below(4) == 0) {
                index.remove(places[slot]);
                alive.erase(slot);
            } else {
                objects[slot].box = randomBox(random, 100, 2);
                index.setBox(places[slot], objects[slot].box);
            }
        }
        for (int i = 0; i < 200; ++i) {
            const uint32_t slot = uint32_t(objects.size());
            objects.push_back({slot, randomBox(random, 100, 2)});
            places.push_back(index.append(objects.back()));
            alive.insert(slot);
        }
        index.refit();
        EXPECT_EQ(index.size(), alive.size());
        expectRight(alive);
        Aabb all;
        for (uint32_t slot : alive) all.grow(objects[slot].box);
        EXPECT_EQ(index.bounds().low, all.low);
        EXPECT_EQ(index.bounds().high, all.high);
    }
    EXPECT_TRUE(index.isWorn());
}

TEST_F(SpatialIndexTest, GrowsFromNothing) {
    std::set<uint32_t> alive;
    for (uint32_t i = 0; i < 5000; ++i) {
        objects.push_back({i, randomBox(random, 100, 2)});
        index.append(objects.back());
        alive.insert(i);
        if (i % 1000 == 7 || i == 64) index.refit(), expectRight(alive);
    }
}

// What a camera finds of a world ten times as large, seen as densely, costs about the same.
TEST_F(SpatialIndexTest, VisitsWhatIsSeenNotWhatExists) {
    const auto blocksVisited = [&](uint32_t side) {
        objects.clear();
        for (uint32_t i = 0; i < side * side; ++i) {
            const vec3 at(float(i % side), 0, float(i / side));
            objects.push_back({i, {at - 0.4f, at + 0.4f}});
        }
        index.build(objects);
        View view;
        view.viewFromWorld = glm::lookAt(vec3(50, 4, 50), vec3(60, 0, 60), vec3(0, 1, 0));
        view.farPlane = 40;
        CullVolume volume;
        volume.add(makeCamera(view, 1.5f).value().frustum);
        std::vector<SpatialIndex::Visit> visits;
        index.visit({&volume, 1}, visits);
        return visits.size();
    };
    const size_t small = blocksVisited(100), large = blocksVisited(1000);
    EXPECT_LT(double(large), 2.5 * double(small)) << small;
}

}  // namespace
}  // namespace rushlight

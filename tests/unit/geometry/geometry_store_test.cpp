#include "renderer/resources/geometry_store.h"

#include "renderer/geometry/mesh_topology.h"
#include "tests/support/memory_device.h"
#include "tests/support/random.h"
#include "tests/support/scenes/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

namespace rushlight {
namespace {

TEST(IsClosed, CubeAndSphereAreOthersAreNot) {
    const auto closed = [](const Shape& s) { return isClosed(s.positions, s.indices); };
    EXPECT_TRUE(closed(makeCube()));
    EXPECT_TRUE(closed(makeSphere(8, 12)));
    for (uint32_t sides = 1; sides < 6; ++sides) EXPECT_FALSE(closed(makeCube(sides))) << sides;
    Shape flipped = makeCube();
    std::swap(flipped.indices[0], flipped.indices[1]);
    EXPECT_FALSE(closed(flipped)) << "a triangle that faces inwards";
    Shape holed = makeSphere(8, 12);
    holed.indices.resize(holed.indices.size() / 2 / 3 * 3);
    EXPECT_FALSE(closed(holed));
}

TEST(RangeAllocator, FreedNeighboursMerge) {
    RangeAllocator ranges;
    const uint32_t a = ranges.allocate(10), b = ranges.allocate(20), c = ranges.allocate(30);
    EXPECT_EQ((std::array<uint32_t, 3>{a, b, c}), (std::array<uint32_t, 3>{0, 10, 30}));
    ranges.release(a, 10);
    ranges.release(c, 30);
    EXPECT_EQ(ranges.allocate(40), 60u) << "no gap is large enough";
    ranges.release(b, 20);
    EXPECT_EQ(ranges.allocate(60), 0u) << "the three gaps are one";
    EXPECT_EQ(ranges.end(), 100u);
}

TEST(RangeAllocator, LivingRangesNeverOverlap) {
    Random random(8);
    RangeAllocator ranges;
    std::map<uint32_t, uint32_t> live;
    uint64_t most = 0, now = 0;
    for (int step = 0; step < 5000; ++step) {
        if (live.empty() || random.below(100) < 55) {
            const uint32_t count = 1 + random.below(50), first = ranges.allocate(count);
            const auto next = live.lower_bound(first);
            if (next != live.end()) {
                ASSERT_LE(first + count, next->first);
            }
            if (next != live.begin()) {
                ASSERT_LE(std::prev(next)->first + std::prev(next)->second, first);
            }
            live[first] = count;
            most = std::max(most, now += count);
        } else {
            const auto victim = std::next(live.begin(), random.below(uint32_t(live.size())));
            ranges.release(victim->first, victim->second);
            now -= victim->second;
            live.erase(victim);
        }
    }
    EXPECT_LT(ranges.end(), most * 2) << "gaps are not used again";
    for (const auto& [first, count] : live) ranges.release(first, count);
    EXPECT_EQ(ranges.allocate(ranges.end()), 0u) << "all gaps are one";
}

class GeometryStoreTest : public testing::Test {
protected:
    MemoryDevice device;
    GeometryStore store{device};

    uint32_t index(uint32_t place) { return device.read<uint32_t>(store.indices(), place); }
    vec3 corner(const GpuMesh& mesh, uint32_t place) {
        return device.read<vec3>(store.streams(mesh.extended).positions,
                                 mesh.firstVertex + index(place));
    }
    void expectHolds(MeshHandle handle, const Shape& shape) {
        const GpuMesh& mesh = *store.find(handle);
        for (uint32_t i = 0; i < shape.indices.size(); ++i)
            ASSERT_EQ(corner(mesh, mesh.firstIndex + i), shape.positions[shape.indices[i]]);
    }
};

TEST_F(GeometryStoreTest, GrowingKeepsWhatIsThere) {
    // 45,451 vertices, the cube behind them, then 80,601: more than the first capacity.
    const Shape filler = makeSphere(150, 300), cube = makeCube(), large = makeSphere(200, 400);
    const auto bare = [](const Shape& shape) {
        MeshDesc desc = shape.desc();
        desc.lods = false;
        return desc;
    };
    const MeshHandle before = *store.create(bare(filler));
    const MeshHandle first = *store.create(cube.desc());
    std::vector<vec4> colors(large.positions.size(), vec4(1));
    const size_t buffers = device.buffers.size();
    const MeshHandle second = *store.create(bare(large));
    expectHolds(before, filler);
    expectHolds(first, cube);
    expectHolds(second, large);
    EXPECT_EQ(device.buffers.size(), buffers) << "the smaller buffers are given back";
    MeshDesc extended = bare(large);
    extended.colors = colors;
    const MeshHandle third = *store.create(extended);
    expectHolds(first, cube);
    expectHolds(third, large);
}

TEST_F(GeometryStoreTest, ADestroyedMeshesPlaceIsUsedAgain) {
    const MeshHandle first = *store.create(makeCube().desc());
    const MeshHandle second = *store.create(makeSphere(5, 5).desc());
    const uint32_t place = store.find(first)->firstVertex;
    store.destroy(first);
    EXPECT_EQ(store.find(first), nullptr);
    const MeshHandle again = *store.create(makeCube().desc());
    EXPECT_EQ(store.find(again)->firstVertex, place);
    EXPECT_EQ(store.find(first), nullptr) << "the old handle stays stale";
    expectHolds(second, makeSphere(5, 5));
    store.destroy(first);
    EXPECT_NE(store.find(again), nullptr) << "destroying a stale handle does nothing";
}

TEST_F(GeometryStoreTest, LevelsSortedByFacingHoldTheTrianglesOfTheirLevel) {
    const Shape sphere = makeSphere(16, 24);
    const MeshHandle handle = *store.create(sphere.desc());
    const GpuMesh& mesh = *store.find(handle);
    expectHolds(handle, sphere);
    ASSERT_GE(mesh.groupedLods, 2u);
    EXPECT_NE(mesh.lods[0].firstIndex, mesh.firstIndex);
    std::vector<uint32_t> sorted(mesh.indexCount), given(mesh.indexCount);
    for (uint32_t i = 0; i < mesh.indexCount; ++i) {
        sorted[i] = index(mesh.lods[0].firstIndex + i);
        given[i] = index(mesh.firstIndex + i);
    }
    std::ranges::sort(sorted);
    std::ranges::sort(given);
    EXPECT_EQ(sorted, given);
    for (uint32_t lod = 0; lod < mesh.groupedLods; ++lod)
        EXPECT_EQ(mesh.facing[lod].firstIndex[mesh.facing[lod].count], mesh.lods[lod].indexCount);
    store.destroy(handle);
    const MeshHandle again = *store.create(sphere.desc());
    EXPECT_EQ(store.find(again)->firstIndex, 0u) << "all of its place is free again";
}

TEST_F(GeometryStoreTest, VerticesAreInTheOrderOfTheirFirstUse) {
    const GpuMesh& mesh = *store.find(*store.create(makeSphere(16, 24).desc()));
    uint32_t next = 0;
    for (uint32_t i = 0; i < mesh.indexCount; ++i) {
        const uint32_t used = index(mesh.lods[0].firstIndex + i);
        ASSERT_LE(used, next);
        next = std::max(next, used + 1);
    }
    EXPECT_EQ(next, mesh.vertexCount) << "moved vertices, which level 0 does not use, come last";
}

TEST_F(GeometryStoreTest, BoundsAndFlagsComeFromTheData) {
    Shape cube = makeCube();
    for (vec3& p : cube.positions) p = p * vec3(1, 2, 3) + vec3(10, 0, 0);
    const GpuMesh& mesh = *store.find(*store.create(cube.desc()));
    EXPECT_EQ(mesh.bounds.low, vec3(9, -2, -3));
    EXPECT_EQ(mesh.bounds.high, vec3(11, 2, 3));
    EXPECT_TRUE(mesh.closed);
    EXPECT_FALSE(mesh.extended);
    EXPECT_FALSE(mesh.hasTangents);
}

TEST_F(GeometryStoreTest, VertexColoursAreClampedToWhatTheyAreKeptIn) {
    const Shape cube = makeCube();
    const std::vector<vec4> colors(cube.positions.size(), vec4(2, -1, 0.5f, 1));
    MeshDesc desc = cube.desc();
    desc.colors = colors;
    const GpuMesh& mesh = *store.find(*store.create(desc));
    const auto extra = device.read<VertexExtra>(store.streams(true).extras, mesh.firstVertex);
    EXPECT_EQ(extra.color[0], 65535);
    EXPECT_EQ(extra.color[1], 0);
    EXPECT_EQ(extra.color[2], 32768);
    EXPECT_EQ(extra.color[3], 65535);
}

TEST_F(GeometryStoreTest, UpdatesMoveVerticesAndBounds) {
    Shape cube = makeCube();
    const MeshHandle handle = *store.create(cube.desc());
    for (vec3& p : cube.positions) p *= 3.0f;
    ASSERT_TRUE(store.update(handle, cube.desc()));
    expectHolds(handle, cube);
    EXPECT_EQ(store.find(handle)->bounds.high, vec3(3));
    EXPECT_FALSE(store.update(handle, makeSphere(4, 4).desc())) << "another number of vertices";
    store.destroy(handle);
    EXPECT_FALSE(store.update(handle, cube.desc()));
}

TEST_F(GeometryStoreTest, AnUpdateThatOpensAMeshIsNoticed) {
    Shape cube = makeCube();
    const MeshHandle handle = *store.create(cube.desc());
    for (uint32_t i = 0; i < 4; ++i) cube.positions[i] += vec3(1, 0, 0);  // one side comes off
    ASSERT_TRUE(store.update(handle, cube.desc()));
    EXPECT_FALSE(store.find(handle)->closed) << "its back faces would be culled from shadow maps";
}

TEST_F(GeometryStoreTest, BadMeshesAreErrorsThatNameTheLabel) {
    const Shape cube = makeCube();
    const std::vector<vec3> few(3, vec3(0, 1, 0));
    const std::vector<uint32_t> beyond = {0, 1, 24}, two = {0, 1};
    std::vector<vec3> nan = cube.positions;
    nan[5].y = std::numeric_limits<float>::quiet_NaN();
    const auto refused = [&](auto&& spoil) {
        MeshDesc desc = cube.desc("barrel");
        spoil(desc);
        const auto made = store.create(desc);
        return !made && made.error().text().find("barrel") != std::string::npos;
    };
    EXPECT_TRUE(refused([&](MeshDesc& d) { d.positions = {}; }));
    EXPECT_TRUE(refused([&](MeshDesc& d) { d.indices = {}; }));
    EXPECT_TRUE(refused([&](MeshDesc& d) { d.indices = two; }));
    EXPECT_TRUE(refused([&](MeshDesc& d) { d.indices = beyond; }));
    EXPECT_TRUE(refused([&](MeshDesc& d) { d.positions = nan; }));
    EXPECT_TRUE(refused([&](MeshDesc& d) { d.normals = few; }));
    EXPECT_TRUE(device.buffers.empty()) << "what is refused leaves nothing";
}

}  // namespace
}  // namespace rushlight

#include "engine/physics/triangle_grid.h"

#include "tests/unit/engine/level_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace rushlight {
namespace {

TEST(TriangleGridTest, NothingIsUnderAnEmptyLevel) {
    const TriangleGrid grid;
    EXPECT_TRUE(grid.isEmpty());
    EXPECT_FALSE(grid.castDown({0, 1, 0}, 100));
}

TEST(TriangleGridTest, LeavesOutBrokenTriangles) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const test::Triangles triangles{{{vec3(0), vec3(1), vec3(2)}},
                                    {{vec3(nan), vec3(1, 0, 0), vec3(0, 0, 1)}},
                                    {{vec3(infinity), vec3(1, 0, 0), vec3(0, 0, 1)}},
                                    {{vec3(0), vec3(1, 0, 0), vec3(0, 0, 1)}}};
    EXPECT_EQ(TriangleGrid(triangles).triangleCount(), 1u);
}

TEST(TriangleGridTest, ARayOnTheSharedEdgeHits) {
    test::Triangles triangles;
    test::addFloor(triangles, 3, 0.5f);
    const TriangleGrid grid(triangles);
    for (float x = -3; x <= 3; x += 0.125f) {
        const auto hit = grid.castDown({x, 2, -x}, 5);
        ASSERT_TRUE(hit) << x;
        EXPECT_NEAR(hit->distance, 1.5f, 1e-5f);
        EXPECT_NEAR(hit->normal.y, 1, 1e-6f);
    }
}

TEST(TriangleGridTest, FindsTheHighestFloorWithinReach) {
    test::Triangles triangles;
    test::addFloor(triangles, 3, 0);
    test::addFloor(triangles, 3, 1);
    const TriangleGrid grid(triangles);
    EXPECT_NEAR(grid.castDown({0.3f, 2, 1}, 9)->distance, 1, 1e-5f);
    EXPECT_NEAR(grid.castDown({0.3f, 0.5f, 1}, 9)->distance, 0.5f, 1e-5f);
    EXPECT_FALSE(grid.castDown({0.3f, 2, 1}, 0.9f));
    EXPECT_FALSE(grid.castDown({4, 2, 1}, 9));
}

TEST(TriangleGridTest, FindsWhatTouchesABoxAsExhaustiveSearchDoes) {
    std::mt19937 random(11);
    const auto number = [&] { return float(int(random() % 4001) - 2000) / 100; };
    test::Triangles triangles;
    for (int i = 0; i < 400; ++i) {
        const vec3 at(number(), number(), number());
        triangles.push_back({{at, at + vec3(number(), number(), number()) * 0.2f,
                              at + vec3(number(), number(), number()) * 0.2f}});
    }
    const TriangleGrid grid(triangles, 1.5f);
    ASSERT_EQ(grid.triangleCount(), triangles.size());
    for (int round = 0; round < 100; ++round) {
        Aabb box;
        box.grow(vec3(number(), number(), number()));
        box.grow(box.low + vec3(3, 2, 4));
        std::set<float> found, expected;
        grid.forEachTouching(box,
                             [&](const CollisionTriangle& t) { found.insert(t.corners[0].x); });
        for (const CollisionTriangle& t : triangles) {
            Aabb own;
            for (const vec3& corner : t.corners) own.grow(corner);
            if (glm::all(glm::lessThanEqual(own.low, box.high)) &&
                glm::all(glm::lessThanEqual(box.low, own.high)))
                expected.insert(t.corners[0].x);
        }
        EXPECT_EQ(found, expected);
    }
}

}  // namespace
}  // namespace rushlight

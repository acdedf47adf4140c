#include "engine/physics/closest.h"

#include <gtest/gtest.h>

#include <random>

namespace rushlight {
namespace {

const vec3 kA(0, 0, 0), kB(2, 0, 0), kC(0, 0, 2);

TEST(ClosestTest, PointsOverFaceEdgeAndCorner) {
    EXPECT_EQ(closestPointOnTriangle(kA, kB, kC, {0.5f, 3, 0.5f}), vec3(0.5f, 0, 0.5f));
    EXPECT_EQ(closestPointOnTriangle(kA, kB, kC, {1, 1, -4}), vec3(1, 0, 0));
    EXPECT_EQ(closestPointOnTriangle(kA, kB, kC, {-3, 1, -4}), vec3(0, 0, 0));
}

TEST(ClosestTest, ASegmentThroughTheTriangleIsZeroAway) {
    const ClosestPoints points = closestPoints({{0.5f, -1, 0.5f}, {0.5f, 1, 0.5f}}, kA, kB, kC);
    EXPECT_EQ(points.distanceSquared, 0);
    EXPECT_EQ(points.first, vec3(0.5f, 0, 0.5f));
}

TEST(ClosestTest, ParallelSegmentsHaveTheirDistance) {
    EXPECT_FLOAT_EQ(closestPoints({{0, 0, 0}, {0, 4, 0}}, {{3, 1, 0}, {3, 2, 0}}).distanceSquared,
                    9);
}

TEST(ClosestTest, NoSampledPairIsNearer) {
    std::mt19937 random(7);
    const auto number = [&] { return float(int(random() % 2001) - 1000) / 250; };
    const auto point = [&] { return vec3(number(), number(), number()); };
    for (int round = 0; round < 300; ++round) {
        const vec3 a = point(), b = point(), c = point();
        const Segment segment{point(), point()};
        const float best = closestPoints(segment, a, b, c).distanceSquared;
        float sampled = 1e9f;
        constexpr int kSteps = 24;
        for (int s = 0; s <= kSteps; ++s) {
            const vec3 on = glm::mix(segment.start, segment.end, float(s) / kSteps);
            for (int u = 0; u <= kSteps; ++u)
                for (int v = 0; u + v <= kSteps; ++v) {
                    const vec3 p = a + (b - a) * (float(u) / kSteps) +
                                   (c - a) * (float(v) / kSteps);
                    sampled = std::min(sampled, glm::dot(p - on, p - on));
                }
        }
        EXPECT_LE(best, sampled + 1e-4f) << "round " << round;
        EXPECT_GE(std::sqrt(best) + 0.9f, std::sqrt(sampled)) << "round " << round;
    }
}

}  // namespace
}  // namespace rushlight

#include "renderer/geometry/facing_groups.h"

#include "tests/support/random.h"
#include "tests/support/scenes/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace rushlight {
namespace {

/// A sphere pushed in and out, so that its triangles face about everywhere and some hide behind
/// others.
Shape makeRock(Random& random, uint32_t rings, float roughness) {
    Shape rock = makeSphere(rings, rings * 3 / 2);
    for (vec3& p : rock.positions)
        p *= 1 +
             roughness * std::sin(9 * p.x + 5 * p.y) * std::cos(7 * p.z + random.uniform(0, 0.1f));
    return rock;
}

mat4x3 randomTransform(Random& random) {
    const mat3 turn(glm::rotate(mat4(1), random.uniform(0, 6), random.direction()));
    const vec3 scale(random.uniform(0.1f, 3) * (random.below(2) ? -1.0f : 1.0f),
                     random.uniform(0.1f, 3), random.uniform(0.1f, 3));
    mat4x3 m(1.0f);
    for (int c = 0; c < 3; ++c) m[c] = turn[c] * scale[c];
    if (random.below(2)) m[0] += 0.5f * m[1];  // sheared
    m[3] = random.vector(-50, 50);
    return m;
}

/// By double precision, in world space: how far the eye is above the plane, as seen by the winding
/// that is the front.
double height(const mat4x3& m, const FacingEye& eye, const vec3& a, const vec3& b, const vec3& c) {
    const glm::dmat3 turn(m);
    const auto at = [&](const vec3& p) { return turn * glm::dvec3(p) + glm::dvec3(m[3]); };
    const glm::dvec3 normal = glm::cross(at(b) - at(a), at(c) - at(a));
    const glm::dvec3 way = glm::dvec3(eye) - double(eye.w) * at(a);
    return glm::dot(normal, way) * (glm::determinant(turn) < 0 ? -1 : 1);
}

FacingEye randomEye(Random& random, const vec3& center) {
    if (random.below(3) == 0) return {random.direction(), 0};
    return {center + random.direction() * std::exp(random.uniform(-2, 5)), 1};
}

TEST(FacingGroups, NoFrontIsEverLeftOut) {
    Random random(31);
    uint64_t leftOut = 0;
    for (int round = 0; round < 60; ++round) {
        Shape shape = makeRock(random, 8 + random.below(14), random.uniform(0, 0.4f));
        const FacingGroups groups = groupByFacing(shape.positions, shape.indices);
        for (int view = 0; view < 60; ++view) {
            const mat4x3 transform = randomTransform(random);
            const FacingEye eye = randomEye(random, transform[3]);
            const uint32_t seen = groupsFacing(groups, transform, eye);
            for (uint32_t g = 0; g < groups.count; ++g) {
                if (seen >> g & 1) continue;
                leftOut += groups.firstIndex[g + 1] - groups.firstIndex[g];
                for (uint32_t i = groups.firstIndex[g]; i < groups.firstIndex[g + 1]; i += 3)
                    ASSERT_LE(height(transform, eye, shape.positions[shape.indices[i]],
                                     shape.positions[shape.indices[i + 1]],
                                     shape.positions[shape.indices[i + 2]]),
                              0)
                        << "round " << round << ", view " << view << ", group " << g;
            }
        }
    }
    EXPECT_GT(leftOut, 100000u);
}

TEST(FacingGroups, FromAfarMostBacksAreLeftOut) {
    Random random(32);
    Shape sphere = makeSphere(20, 30);
    const FacingGroups groups = groupByFacing(sphere.positions, sphere.indices);
    uint64_t drawn = 0, all = 0;
    for (int view = 0; view < 200; ++view) {
        const uint32_t seen = groupsFacing(groups, mat4x3(1.0f), {random.direction() * 50.0f, 1});
        for (uint32_t g = 0; g < groups.count; ++g) {
            const uint32_t size = groups.firstIndex[g + 1] - groups.firstIndex[g];
            all += size;
            if (seen >> g & 1) drawn += size;
        }
    }
    EXPECT_LT(double(drawn), 0.75 * double(all));
    EXPECT_GT(double(drawn), 0.5 * double(all));
}

TEST(FacingGroups, TheTrianglesStayTheSame) {
    Shape sphere = makeSphere(10, 15);
    const auto sorted = [](const std::vector<uint32_t>& indices) {
        std::vector<std::array<uint32_t, 3>> triangles;
        for (size_t i = 0; i < indices.size(); i += 3) {
            std::array<uint32_t, 3> t = {indices[i], indices[i + 1], indices[i + 2]};
            std::ranges::rotate(t, std::ranges::min_element(t));  // the winding stays
            triangles.push_back(t);
        }
        std::ranges::sort(triangles);
        return triangles;
    };
    const auto before = sorted(sphere.indices);
    const FacingGroups groups = groupByFacing(sphere.positions, sphere.indices);
    EXPECT_EQ(sorted(sphere.indices), before);
    EXPECT_EQ(groups.firstIndex[0], 0u);
    EXPECT_EQ(groups.firstIndex[groups.count], sphere.indices.size());
    for (uint32_t g = 0; g < groups.count; ++g)
        EXPECT_LT(groups.firstIndex[g], groups.firstIndex[g + 1]) << g;
}

TEST(FacingGroups, ASheetIsGoneFromBehind) {
    Shape sheet = makeCube(1);
    const FacingGroups groups = groupByFacing(sheet.positions, sheet.indices);
    EXPECT_EQ(groups.count, 1u);
    EXPECT_EQ(groupsFacing(groups, mat4x3(1.0f), {3, 0, 0, 1}), 1u);
    EXPECT_EQ(groupsFacing(groups, mat4x3(1.0f), {0.9f, 0, 0, 1}), 0u) << "it is at x = 1";
    EXPECT_EQ(groupsFacing(groups, mat4x3(1.0f), {-1, 0, 0, 0}), 0u);
    EXPECT_EQ(groupsFacing(groups, mat4x3(1.0f), {1, 0, 0, 0}), 1u);
    mat4x3 mirrored(1.0f);
    mirrored[0].x = -1;
    EXPECT_EQ(groupsFacing(groups, mirrored, {-3, 0, 0, 1}), 1u);
    EXPECT_EQ(groupsFacing(groups, mirrored, {3, 0, 0, 1}), 0u);
}

TEST(FacingGroups, WhatCannotBeToldIsDrawn) {
    Shape sphere = makeSphere(10, 15);
    for (uint32_t c = 0; c < 3; ++c) sphere.indices.push_back(sphere.indices[0]);  // no area
    const FacingGroups groups = groupByFacing(sphere.positions, sphere.indices);
    const uint32_t all = groupsFacing(groups, mat4x3(0.0f), {9, 0, 0, 1});
    EXPECT_EQ(std::popcount(all), int(groups.count)) << "a transform that flattens";
    const float nan = std::nanf("");
    EXPECT_EQ(groupsFacing(groups, mat4x3(1.0f), {nan, 0, 0, 1}), all);
    for (const vec3& from : {vec3(9, 0, 0), vec3(-9, 0, 0), vec3(0, 9, 0), vec3(0, 0, -9)})
        EXPECT_TRUE(groupsFacing(groups, mat4x3(1.0f), {from, 1}) >> (groups.count - 1) & 1)
            << "a triangle without a normal";
}

}  // namespace
}  // namespace rushlight

#include "engine/assets/tangents.h"

#include <gtest/gtest.h>

namespace rushlight::assets {
namespace {

/// A unit square in the xy plane, facing +z.
Geometry quad(const std::vector<vec2>& uv) {
    Geometry geometry;
    geometry.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    geometry.normals.assign(4, vec3(0, 0, 1));
    geometry.uv0 = uv;
    geometry.indices = {0, 1, 2, 0, 2, 3};
    return geometry;
}

void expectTangent(const vec4& actual, const vec4& expected) {
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(actual[c], expected[c], 1e-6f) << "component " << c;
}

TEST(AssetsTangents, FollowIncreasingU) {
    // v runs down in glTF, so upright texture coordinates have a bitangent towards +y: w = +1
    Geometry geometry = quad({{0, 1}, {1, 1}, {1, 0}, {0, 0}});
    makeTangents(geometry, 0);
    ASSERT_EQ(geometry.tangents.size(), 4u);
    for (const vec4& tangent : geometry.tangents) {
        expectTangent(tangent, {1, 0, 0, 1});
        EXPECT_NEAR((glm::cross(vec3(0, 0, 1), vec3(tangent)) * tangent.w).y, 1, 1e-6f);
    }
}

TEST(AssetsTangents, MirroredCoordinatesChangeTheSign) {
    Geometry geometry = quad({{1, 1}, {0, 1}, {0, 0}, {1, 0}});
    makeTangents(geometry, 0);
    for (const vec4& tangent : geometry.tangents) expectTangent(tangent, {-1, 0, 0, -1});
}

TEST(AssetsTangents, RotatedCoordinates) {
    Geometry geometry = quad({{0, 0}, {0, 1}, {1, 1}, {1, 0}});  // u runs along +y, v along +x
    makeTangents(geometry, 0);
    for (const vec4& tangent : geometry.tangents) expectTangent(tangent, {0, 1, 0, 1});
}

TEST(AssetsTangents, TheMirrorSeamIsSplit) {
    // two quads share the edge x = 1; u runs 0 1 0, mirrored there, so its two vertices need two
    // tangents
    Geometry geometry;
    geometry.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
    geometry.normals.assign(6, vec3(0, 0, 1));
    geometry.uv0 = {{0, 1}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {0, 0}};
    geometry.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
    makeTangents(geometry, 0);
    ASSERT_EQ(geometry.positions.size(), 8u);
    ASSERT_EQ(geometry.uv0.size(), 8u);
    for (size_t corner = 0; corner < 12; ++corner) {
        const vec4 expected = corner < 6 ? vec4(1, 0, 0, 1) : vec4(-1, 0, 0, -1);
        expectTangent(geometry.tangents[geometry.indices[corner]], expected);
    }
}

TEST(AssetsTangents, CornersAreWeightedByTheirAngle) {
    // A vertex with a right angle and a half of one, in one plane, whose triangles disagree on u by
    // 90 degrees: the sum is 90 parts +x to 45 parts +y.
    Geometry geometry;
    geometry.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 1, 0}};
    geometry.normals.assign(4, vec3(0, 0, 1));
    geometry.indices = {0, 1, 2, 0, 2, 3};
    // first: u = x, v = -y; second: uv(0) = 0, uv(2) = (0, -1), and solved for du = +y: u = y there
    // needs uv(2).x = 1, so instead the directions are read off the uv below and compared through
    // their own formula
    geometry.uv0 = {{0, 0}, {1, 0}, {0, -1}, {-1, -2}};
    makeTangents(geometry, 0);
    // second triangle: e1 = (0,1), e2 = (-1,1), t1 = (0,-1), t2 = (-1,-2): t2.y e1 - t1.y e2 =
    // (-1,-1), mirrored: (1,1)/sqrt 2
    const float half = 0.70710678f;
    const vec2 sum = 90.0f * vec2(1, 0) + 45.0f * vec2(half, half);
    const vec2 unit = sum / glm::length(sum);
    expectTangent(geometry.tangents[0], {unit.x, unit.y, 0, 1});
}

TEST(AssetsTangents, DegenerateCoordinatesGiveUnitTangents) {
    Geometry geometry = quad({{0, 0}, {0, 0}, {0, 0}, {0, 0}});
    makeTangents(geometry, 0);
    for (const vec4& tangent : geometry.tangents) {
        EXPECT_NEAR(glm::length(vec3(tangent)), 1, 1e-6f);
        EXPECT_NEAR(tangent.z, 0, 1e-6f);
    }
}

TEST(AssetsTangents, DegenerateTrianglesBorrowFromTheirNeighbours) {
    Geometry geometry = quad({{0, 1}, {1, 1}, {1, 0}, {0, 0}});
    geometry.indices.insert(geometry.indices.end(), {0, 1, 1});
    makeTangents(geometry, 0);
    EXPECT_EQ(geometry.positions.size(), 4u);
    for (const vec4& tangent : geometry.tangents) expectTangent(tangent, {1, 0, 0, 1});
}

}  // namespace
}  // namespace rushlight::assets

#pragma once
// The triangles of a level of detail in groups that face about one way, so that a view leaves out
// whole groups of which it would see only the backs. What is left out would have been culled
// triangle by triangle: the picture is the same.

#include "engine/core/math.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rushlight {

/// A cone around the normals of each group, and how far its planes are from one point, in the
/// coarse numbers that are quick to fetch, rounded to where less is left out. With a = axis / 127,
/// |a| about 1, for every triangle of group g with the unit normal n through p
///     dot(n, a/|a|) >= cos θ,   |a| sin θ <= sine / 127,   |a| cos θ dot(n, p - center) >= limit *
///     extent / 127.
struct alignas(64) FacingGroups {
    static constexpr uint32_t kMost = 31;

    std::array<std::array<int8_t, kMost + 1>, 3> axis{};
    std::array<uint8_t, kMost + 1> sine{};
    std::array<int8_t, kMost + 1> limit{};
    vec3 center{0};
    float extent = 0;  ///< metres of the mesh's space
    uint32_t count = 0;
    alignas(64) std::array<uint32_t, kMost + 1> firstIndex{};  ///< in the level; of the last group,
                                                               ///< the end
};

/// Levels with fewer triangles are not worth the look and the draws.
inline constexpr uint32_t kFewestTrianglesForFacing = 256;

/// Sorts the triangles of a level by group, and within a group for the vertex cache.
FacingGroups groupByFacing(std::span<const vec3> positions, std::span<uint32_t> indices);

/// Where a view is seen from: a point (w = 1), or the way to the viewer of an orthographic view (w
/// = 0). World space.
using FacingEye = vec4;

/// Bit g: group g may show the eye a front, as counter-clockwise in the space of the mesh.
/// Mirroring transforms turn fronts and the winding that counts as front alike.
uint32_t groupsFacing(const FacingGroups& groups, const mat4x3& worldFromLocal,
                      const FacingEye& eye);

}  // namespace rushlight

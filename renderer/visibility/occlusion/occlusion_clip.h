#pragma once
// A triangle cut at the near plane and at the guard band.

#include "engine/core/math.h"

#include <array>
#include <cstdint>
#include <span>

namespace rushlight {

inline constexpr uint8_t kEdgeOfNearPlane = 3, kEdgeOfGuardBand = 4;

struct ClipVertex {
    glm::dvec4 position;  ///< clip space
    uint32_t corner;      ///< 0 to 2 for a corner of the triangle, 3 for a new one
    uint8_t edge;  ///< from here to the next: 0 to 2 for part of the triangle's, else kEdgeOf...
};

inline constexpr uint32_t kMaxClipVertices = 9;  ///< three corners, one more for each plane, one to
                                                 ///< spare

struct ClipPolygon {
    std::array<ClipVertex, kMaxClipVertices> vertices;
    uint32_t count = 0;
};

/// Keeps z <= nearFactor * w, |x| <= guard.x * w and |y| <= guard.y * w. Two triangles with a
/// common edge get the same new vertices on it. No vertices when nothing is left or rounding has
/// made the polygon concave.
ClipPolygon clipTriangle(std::span<const glm::dvec4, 3> corners, double nearFactor,
                         glm::dvec2 guard);

}  // namespace rushlight

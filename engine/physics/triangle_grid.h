#pragma once
// The level as something to bump into: static triangles in the cells of a grid over the ground
// plane.

#include "engine/core/bounds.h"
#include "engine/core/math.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rushlight {

struct CollisionTriangle {
    std::array<vec3, 3> corners;
};

struct RayHit {
    float distance = 0;
    vec3 normal{0, 1, 0};  ///< unit, on the side that the ray came from
};

/// Immutable once built; any number of threads may ask.
class TriangleGrid {
public:
    TriangleGrid() = default;
    /// Triangles without area or with coordinates that are not finite are left out. `cellSize` in
    /// metres; it is made larger when the level would need more than kMaxCellsPerAxis.
    explicit TriangleGrid(std::span<const CollisionTriangle> triangles, float cellSize = 2);

    static constexpr int kMaxCellsPerAxis = 256;

    bool isEmpty() const { return triangles_.empty(); }
    size_t triangleCount() const { return triangles_.size(); }
    const Aabb& bounds() const { return bounds_; }

    /// Calls `visit(const CollisionTriangle&)` for triangles whose box touches `box`; one that
    /// spans cells may come more than once.
    template <class Visit>
    void forEachTouching(const Aabb& box, Visit&& visit) const {
        if (isEmpty()) return;
        const CellRange range = cellsOf(box);
        for (int z = range.lowZ; z <= range.highZ; ++z)
            for (int x = range.lowX; x <= range.highX; ++x)
                for (const uint32_t index : cell(x, z))
                    if (touches(boxes_[index], box)) visit(triangles_[index]);
    }

    /// The first triangle under `from`, at most `distance` metres down. Both sides of a triangle
    /// count.
    std::optional<RayHit> castDown(const vec3& from, float distance) const;

private:
    struct CellRange {
        int lowX, highX, lowZ, highZ;
    };
    static bool touches(const Aabb& a, const Aabb& b) {
        return glm::all(glm::lessThanEqual(a.low, b.high)) &&
               glm::all(glm::lessThanEqual(b.low, a.high));
    }
    CellRange cellsOf(const Aabb& box) const;
    std::span<const uint32_t> cell(int x, int z) const;
    void fillCells();

    std::vector<CollisionTriangle> triangles_;
    std::vector<Aabb> boxes_;
    std::vector<uint32_t> cellStarts_;  ///< into indices_, one more than there are cells
    std::vector<uint32_t> indices_;
    Aabb bounds_;
    float cellSize_ = 1;
    int cellsX_ = 0;
    int cellsZ_ = 0;
};

}  // namespace rushlight

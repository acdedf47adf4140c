#include "engine/physics/triangle_grid.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

vec3 areaVector(const CollisionTriangle& t) {
    return glm::cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]);
}

/// Finite and not collapsed to a line. An infinite or NaN coordinate makes the comparison false.
bool isUsable(const CollisionTriangle& t) {
    const vec3 area = areaVector(t);
    const float size = glm::dot(area, area);
    return size > 1e-16f && std::isfinite(size);
}

/// Where the vertical line through `p` meets the triangle's plane, if it does so inside the
/// triangle. A point on an edge is inside: two triangles that share the edge leave no gap.
std::optional<float> heightAt(const CollisionTriangle& t, const vec3& p) {
    const auto edge = [&](const vec3& a, const vec3& b) {
        return (b.x - a.x) * (p.z - a.z) - (b.z - a.z) * (p.x - a.x);
    };
    const vec3& a = t.corners[0];
    const vec3& b = t.corners[1];
    const vec3& c = t.corners[2];
    const float wc = edge(a, b);
    const float wa = edge(b, c);
    const float wb = edge(c, a);
    const bool inside = (wa >= 0 && wb >= 0 && wc >= 0) || (wa <= 0 && wb <= 0 && wc <= 0);
    const float sum = wa + wb + wc;
    if (!inside || sum == 0) return std::nullopt;  // sum 0: the triangle stands upright
    return (wa * a.y + wb * b.y + wc * c.y) / sum;
}

}  // namespace

TriangleGrid::TriangleGrid(std::span<const CollisionTriangle> triangles, float cellSize) {
    for (const CollisionTriangle& triangle : triangles) {
        if (!isUsable(triangle)) continue;
        Aabb box;
        for (const vec3& corner : triangle.corners) box.grow(corner);
        triangles_.push_back(triangle);
        boxes_.push_back(box);
        bounds_.grow(box);
    }
    if (isEmpty()) return;
    const vec3 size = bounds_.high - bounds_.low;
    cellSize_ = std::max(cellSize, std::max(size.x, size.z) / float(kMaxCellsPerAxis - 1));
    cellsX_ = int(size.x / cellSize_) + 1;
    cellsZ_ = int(size.z / cellSize_) + 1;
    fillCells();
}

/// Counts, sums up, then places: a compressed row per cell.
void TriangleGrid::fillCells() {
    const auto forEachCell = [&](auto&& body) {
        for (uint32_t i = 0; i < uint32_t(boxes_.size()); ++i) {
            const CellRange range = cellsOf(boxes_[i]);
            for (int z = range.lowZ; z <= range.highZ; ++z)
                for (int x = range.lowX; x <= range.highX; ++x) body(size_t(z) * cellsX_ + x, i);
        }
    };
    cellStarts_.assign(size_t(cellsX_) * cellsZ_ + 1, 0);
    forEachCell([&](size_t cell, uint32_t) { ++cellStarts_[cell + 1]; });
    for (size_t i = 1; i < cellStarts_.size(); ++i) cellStarts_[i] += cellStarts_[i - 1];
    indices_.resize(cellStarts_.back());
    std::vector<uint32_t> next(cellStarts_.begin(), cellStarts_.end() - 1);
    forEachCell([&](size_t cell, uint32_t i) { indices_[next[cell]++] = i; });
}

TriangleGrid::CellRange TriangleGrid::cellsOf(const Aabb& box) const {
    const auto at = [&](float value, float low, int count) {
        return int(std::clamp((value - low) / cellSize_, 0.0f, float(count - 1)));
    };
    return {at(box.low.x, bounds_.low.x, cellsX_), at(box.high.x, bounds_.low.x, cellsX_),
            at(box.low.z, bounds_.low.z, cellsZ_), at(box.high.z, bounds_.low.z, cellsZ_)};
}

std::span<const uint32_t> TriangleGrid::cell(int x, int z) const {
    const size_t index = size_t(z) * cellsX_ + x;
    return std::span(indices_).subspan(cellStarts_[index],
                                       cellStarts_[index + 1] - cellStarts_[index]);
}

std::optional<RayHit> TriangleGrid::castDown(const vec3& from, float distance) const {
    std::optional<RayHit> nearest;
    const Aabb column{from - vec3(0, distance, 0), from};
    forEachTouching(column, [&](const CollisionTriangle& triangle) {
        const std::optional<float> height = heightAt(triangle, from);
        if (!height) return;
        const float fall = from.y - *height;
        if (fall < 0 || fall > distance || (nearest && fall >= nearest->distance)) return;
        const vec3 normal = glm::normalize(areaVector(triangle));
        nearest = RayHit{fall, normal.y < 0 ? -normal : normal};
    });
    return nearest;
}

}  // namespace rushlight

#include "renderer/geometry/surface_distance.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

constexpr int kMostCells = 64;  // along one axis

float squaredDistanceToSegment(const vec3& point, const vec3& start, const vec3& along) {
    const float length = glm::dot(along, along);
    const float t = length > 0 ? std::clamp(glm::dot(point - start, along) / length, 0.0f, 1.0f)
                               : 0;
    const vec3 apart = point - start - t * along;
    return glm::dot(apart, apart);
}

// Or anything that is at least `nearest`, where it is not nearer. The nearest point is the foot of
// the perpendicular where that is inside (all barycentric coordinates positive, here times the
// squared double area), else on an edge.
float squaredDistance(const vec3& point, const vec3& a, const vec3& b, const vec3& c,
                      float nearest) {
    const vec3 ab = b - a, ac = c - a, ap = point - a;
    const vec3 normal = glm::cross(ab, ac);
    const float area = glm::dot(normal, normal), height = glm::dot(ap, normal);
    if (height * height > nearest * area) return nearest;
    const float towardsC = glm::dot(glm::cross(ab, ap), normal);
    const float towardsB = glm::dot(glm::cross(ap, ac), normal);
    if (area > 0 && towardsC >= 0 && towardsB >= 0 && towardsB + towardsC <= area)
        return height * height / area;
    return std::min({squaredDistanceToSegment(point, a, ab), squaredDistanceToSegment(point, a, ac),
                     squaredDistanceToSegment(point, b, c - b)});
}

}  // namespace

template <class F>
void SurfaceGrid::forCells(const glm::ivec3& low, const glm::ivec3& high, F&& f) const {
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) f(glm::ivec3(x, y, z));
}

SurfaceGrid::SurfaceGrid(std::span<const vec3> positions, std::span<const vec3> normals,
                         std::span<const uint32_t> triangles, const Aabb& bounds)
    : positions_(positions), normals_(normals), triangles_(triangles), low_(bounds.low) {
    // A surface of n triangles goes through about n of the cells when there are √n of them along an
    // axis.
    const vec3 extent = bounds.high - bounds.low;
    const float longest = std::max({extent.x, extent.y, extent.z});
    const int cells = std::clamp(int(std::sqrt(float(triangles.size() / 3))), 1, kMostCells);
    cellSize_ = longest > 0 ? longest / float(cells) : 1;
    size_ = glm::ivec3(kMostCells);
    size_ = cellOf(bounds.high) + 1;

    const auto forEntries = [&](auto&& f) {
        for (uint32_t t = 0; t < triangles.size() / 3; ++t) {
            Aabb box;
            for (size_t k = 0; k < 3; ++k) box.grow(positions[triangles[t * 3 + k]]);
            forCells(cellOf(box.low), cellOf(box.high),
                     [&](const glm::ivec3& cell) { f(cellIndex(cell), t); });
        }
    };
    firsts_.assign(cellIndex(size_ - 1) + 2, 0);
    forEntries([&](size_t cell, uint32_t) { ++firsts_[cell]; });
    uint32_t total = 0;
    for (uint32_t& first : firsts_) first = total += first;  // the ends, for now
    entries_.resize(total);
    forEntries([&](size_t cell, uint32_t t) { entries_[--firsts_[cell]] = t; });
}

glm::ivec3 SurfaceGrid::cellOf(const vec3& point) const {
    return glm::clamp(glm::ivec3((point - low_) / cellSize_), glm::ivec3(0), size_ - 1);
}

// Squared; `nearest` where the triangle is not nearer or its shading normal, beside the point,
// looks another way.
float SurfaceGrid::facingDistance(const vec3& point, const vec3& normal, const uint32_t* corners,
                                  float nearest) const {
    constexpr float kCosine = 0.906f;  // 25 degrees
    const vec3 &a = positions_[corners[0]], &b = positions_[corners[1]],
               &c = positions_[corners[2]];
    const float squared = squaredDistance(point, a, b, c, nearest);
    if (squared >= nearest) return nearest;
    const vec3 ab = b - a, ac = c - a, ap = point - a, up = glm::cross(ab, ac);
    const float area = std::max(glm::dot(up, up), 1e-30f);
    const float v = std::clamp(glm::dot(glm::cross(ap, ac), up) / area, 0.0f, 1.0f);
    const float w = std::clamp(glm::dot(glm::cross(ab, ap), up) / area, 0.0f, 1.0f - v);
    const vec3 here = normals_[corners[0]] * (1 - v - w) + normals_[corners[1]] * v +
                      normals_[corners[2]] * w;
    const float cosine = glm::dot(here, normal);
    const bool agrees = cosine >= 0 && cosine * cosine >= kCosine * kCosine * glm::dot(here, here) *
                                                              glm::dot(normal, normal);
    return agrees ? squared : nearest;
}

// Over the cells at `radius` from `cell` along one axis and no more along the others.
void SurfaceGrid::searchShell(const vec3& point, const vec3& normal, const glm::ivec3& cell,
                              int radius, float enough, Nearest& best) const {
    forCells(glm::max(cell - radius, 0), glm::min(cell + radius, size_ - 1),
             [&](const glm::ivec3& at) {
                 const glm::ivec3 apart = glm::abs(at - cell);
                 if (std::max({apart.x, apart.y, apart.z}) != radius || best.squared <= enough)
                     return;
                 const size_t index = cellIndex(at);
                 for (uint32_t e = firsts_[index]; e < firsts_[index + 1]; ++e) {
                     const uint32_t* corners = &triangles_[size_t(entries_[e]) * 3];
                     const float squared = facingDistance(point, normal, corners, best.squared);
                     if (squared < best.squared) best = {squared, corners};
                     if (squared <= enough) return;
                 }
             });
}

SurfaceGrid::Nearest SurfaceGrid::nearest(const vec3& point, const vec3& normal, float enough,
                                          float most) const {
    const glm::ivec3 cell = cellOf(point);
    const vec3 within = (point - low_) / cellSize_ - vec3(cell);
    const vec3 walls = glm::min(within, 1.0f - within);  // of the cell; negative outside the grid
    const float inset = 0.99f * std::max(std::min({walls.x, walls.y, walls.z}), 0.0f);
    Nearest best{most * most, nullptr};
    for (int radius = 0; radius <= kMostCells; ++radius) {
        // Whatever is in this shell or farther is at least so far away.
        const float searched = (float(radius - 1) + inset) * cellSize_;
        if (radius > 0 && best.squared <= searched * searched) break;
        searchShell(point, normal, cell, radius, enough * enough, best);
        if (best.squared <= enough * enough) break;
    }
    return best;
}

float SurfaceGrid::distance(const vec3& point, const vec3& normal, float least, float most) const {
    return std::max(std::sqrt(nearest(point, normal, least, most).squared), least);
}

std::optional<SurfaceGrid::Plane> SurfaceGrid::nearestPlane(const vec3& point, const vec3& normal,
                                                            float least, float most) const {
    const uint32_t* corners = nearest(point, normal, least, most).corners;
    if (!corners) return {};
    const vec3& a = positions_[corners[0]];
    const vec3 up = glm::cross(positions_[corners[1]] - a, positions_[corners[2]] - a);
    const float length = glm::length(up);
    if (!(length > 0)) return {};
    const vec3 n = up * ((glm::dot(up, normal) < 0 ? -1.0f : 1.0f) / length);
    return Plane{n, glm::dot(point - a, n)};
}

}  // namespace rushlight

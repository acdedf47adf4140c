#pragma once
// How far apart two triangle meshes are, in place and in shading, by a uniform grid over the
// triangles of one of them.

#include "engine/core/bounds.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rushlight {

class SurfaceGrid {
public:
    /// `bounds` holds about all triangles and points that will be asked for; what is outside takes
    /// longer. The spans are read until the grid is gone; `normals` (unit) are as long as
    /// `positions`.
    SurfaceGrid(std::span<const vec3> positions, std::span<const vec3> normals,
                std::span<const uint32_t> triangles, const Aabb& bounds);

    /// The distance from `point` to the part of the surface that faces about the way of `normal`
    /// (any length), within 25 degrees; or what of `least` and `most` it is beyond. The nearer they
    /// are to each other the less it takes: a maximum over many points costs little more than one
    /// glance at each.
    float distance(const vec3& point, const vec3& normal, float least, float most) const;

    struct Plane {
        vec3 normal;         ///< unit; to the side that the shading normals are on
        float distance = 0;  ///< of the point: above it, along the normal
    };
    /// The plane of the nearest triangle that faces that way, or of any within `least`; none if
    /// none is within `most`.
    std::optional<Plane> nearestPlane(const vec3& point, const vec3& normal, float least,
                                      float most) const;

private:
    glm::ivec3 cellOf(const vec3& point) const;
    size_t cellIndex(const glm::ivec3& cell) const {
        return (size_t(cell.z) * size_t(size_.y) + size_t(cell.y)) * size_t(size_.x) +
               size_t(cell.x);
    }
    template <class F>
    void forCells(const glm::ivec3& low, const glm::ivec3& high, F&& f) const;
    struct Nearest {
        float squared = 0;  // or the most that was asked for
        const uint32_t* corners = nullptr;
    };
    Nearest nearest(const vec3& point, const vec3& normal, float enough, float most) const;
    void searchShell(const vec3& point, const vec3& normal, const glm::ivec3& cell, int radius,
                     float enough, Nearest& best) const;
    float facingDistance(const vec3& point, const vec3& normal, const uint32_t* corners,
                         float nearest) const;

    std::span<const vec3> positions_, normals_;
    std::span<const uint32_t> triangles_;
    vec3 low_{0};
    float cellSize_ = 1;
    glm::ivec3 size_{1};
    std::vector<uint32_t> firsts_, entries_;  // entries_[firsts_[c] .. firsts_[c + 1]) are the
                                              // triangles of cell c
};

}  // namespace rushlight

#include "engine/assets/geometry_tools.h"

#include <cmath>
#include <numeric>

namespace rushlight::assets {
namespace {

template <class T>
void gather(std::vector<T>& values, const std::vector<uint32_t>& source) {
    if (values.empty()) return;
    std::vector<T> picked(source.size());
    for (size_t i = 0; i < source.size(); ++i) picked[i] = values[source[i]];
    values = std::move(picked);
}

/// Twice the area long.
vec3 faceNormal(const Geometry& geometry, size_t triangle) {
    const vec3& a = geometry.positions[geometry.indices[triangle * 3]];
    const vec3& b = geometry.positions[geometry.indices[triangle * 3 + 1]];
    const vec3& c = geometry.positions[geometry.indices[triangle * 3 + 2]];
    return glm::cross(b - a, c - a);
}

vec3 unitOr(const vec3& v, const vec3& fallback) {
    const float length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : fallback;
}

constexpr vec3 kAnyNormal{0, 0, 1};

}  // namespace

void gatherVertices(Geometry& geometry, const std::vector<uint32_t>& source) {
    gather(geometry.positions, source);
    gather(geometry.normals, source);
    gather(geometry.tangents, source);
    gather(geometry.uv0, source);
    gather(geometry.uv1, source);
    gather(geometry.colors, source);
    gather(geometry.skin, source);
    for (MorphTarget& target : geometry.morphTargets) {
        gather(target.positions, source);
        gather(target.normals, source);
        gather(target.tangents, source);
    }
}

void makeFlatNormals(Geometry& geometry) {
    geometry.normals.clear();
    geometry.tangents.clear();
    gatherVertices(geometry, std::vector<uint32_t>(geometry.indices));
    std::iota(geometry.indices.begin(), geometry.indices.end(), 0u);
    geometry.normals.resize(geometry.positions.size());
    for (size_t t = 0; t < geometry.indices.size() / 3; ++t) {
        const vec3 normal = unitOr(faceNormal(geometry, t), kAnyNormal);
        for (size_t corner = 0; corner < 3; ++corner) geometry.normals[t * 3 + corner] = normal;
    }
}

void repairNormals(Geometry& geometry) {
    bool broken = false;
    for (vec3& normal : geometry.normals) {
        normal = unitOr(normal, vec3(0));
        broken |= normal == vec3(0);
    }
    if (!broken) return;
    std::vector<vec3> sums(geometry.normals.size(), vec3(0));
    for (size_t t = 0; t < geometry.indices.size() / 3; ++t)
        for (size_t corner = 0; corner < 3; ++corner)
            sums[geometry.indices[t * 3 + corner]] += faceNormal(geometry, t);
    for (size_t i = 0; i < sums.size(); ++i)
        if (geometry.normals[i] == vec3(0)) geometry.normals[i] = unitOr(sums[i], kAnyNormal);
}

void computeBounds(Geometry& geometry) {
    geometry.bounds = Aabb();
    for (const vec3& position : geometry.positions) geometry.bounds.grow(position);
}

}  // namespace rushlight::assets

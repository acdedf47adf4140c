#include "renderer/scene_bridge/deform.h"

#include <algorithm>

namespace rushlight {
namespace {

vec3 normalizedOr(const vec3& v, const vec3& fallback) {
    const float length = glm::length(v);
    return length > 0 ? v / length : fallback;
}

void morph(const assets::Geometry& geometry, std::span<const float> weights,
           DeformedVertices& result) {
    const size_t targets = std::min(weights.size(), geometry.morphTargets.size());
    for (size_t t = 0; t < targets; ++t) {
        const assets::MorphTarget& target = geometry.morphTargets[t];
        const float weight = weights[t];
        if (weight == 0) continue;
        for (size_t i = 0; i < target.positions.size(); ++i)
            result.positions[i] += weight * target.positions[i];
        for (size_t i = 0; i < target.normals.size(); ++i)
            result.normals[i] += weight * target.normals[i];
        if (result.tangents.empty()) continue;
        for (size_t i = 0; i < target.tangents.size(); ++i)
            result.tangents[i] += vec4(weight * target.tangents[i], 0);
    }
}

mat4 skinTransform(const assets::VertexSkin& skin, std::span<const mat4> joints) {
    mat4 m(0);
    for (int k = 0; k < 4; ++k)
        if (skin.weights[k] != 0) m += skin.weights[k] * joints[skin.joints[size_t(k)]];
    return m;
}

void skin(const assets::Geometry& geometry, std::span<const mat4> joints,
          DeformedVertices& result) {
    for (size_t i = 0; i < geometry.skin.size(); ++i) {
        const mat4 m = skinTransform(geometry.skin[i], joints);
        const mat3 directions(m);
        result.positions[i] = vec3(m * vec4(result.positions[i], 1));
        // The cofactor matrix takes normals: inverse transpose times the determinant, and exists
        // where that does not.
        const mat3 normals(glm::cross(directions[1], directions[2]),
                           glm::cross(directions[2], directions[0]),
                           glm::cross(directions[0], directions[1]));
        result.normals[i] = normals * result.normals[i];
        if (!result.tangents.empty())
            result.tangents[i] = vec4(directions * vec3(result.tangents[i]), result.tangents[i].w);
    }
}

}  // namespace

void deform(const assets::Geometry& geometry, std::span<const float> weights,
            std::span<const mat4> joints, DeformedVertices& result) {
    result.positions = geometry.positions;
    result.normals = geometry.normals;
    result.tangents = geometry.tangents;
    morph(geometry, weights, result);
    if (!joints.empty()) skin(geometry, joints, result);
    for (size_t i = 0; i < result.normals.size(); ++i)
        result.normals[i] = normalizedOr(result.normals[i], geometry.normals[i]);
    for (size_t i = 0; i < result.tangents.size(); ++i) {
        const vec3 direction = normalizedOr(vec3(result.tangents[i]), vec3(geometry.tangents[i]));
        result.tangents[i] = vec4(direction, result.tangents[i].w);
    }
}

}  // namespace rushlight

#include "engine/scene/deform.h"

#include <algorithm>

namespace rushlight::scene {
namespace {

using assets::Geometry;
using assets::Model;
using assets::MorphTarget;
using assets::Skin;
using assets::VertexSkin;

vec3 unitOr(const vec3& v, const vec3& fallback) {
    const float length = glm::length(v);
    return length > 0 ? v / length : fallback;
}

void addMorphTarget(const MorphTarget& target, float weight, DeformedVertices& out) {
    for (size_t i = 0; i < target.positions.size(); ++i)
        out.positions[i] += weight * target.positions[i];
    for (size_t i = 0; i < target.normals.size(); ++i) out.normals[i] += weight * target.normals[i];
    const size_t tangents = std::min(target.tangents.size(), out.tangents.size());
    for (size_t i = 0; i < tangents; ++i)
        out.tangents[i] += vec4(weight * target.tangents[i], 0.0f);
}

void normalizeDirections(const Geometry& geometry, DeformedVertices& out) {
    for (size_t i = 0; i < out.normals.size(); ++i)
        out.normals[i] = unitOr(out.normals[i], geometry.normals[i]);
    for (size_t i = 0; i < out.tangents.size(); ++i)
        out.tangents[i] = vec4(unitOr(vec3(out.tangents[i]), vec3(geometry.tangents[i])),
                               out.tangents[i].w);
}

std::vector<mat4x3> jointMatrices(const Skin& skin, const Pose& pose) {
    std::vector<mat4x3> matrices(skin.joints.size());
    for (size_t j = 0; j < matrices.size(); ++j)
        matrices[j] = toAffine(pose.worldFromNode[size_t(skin.joints[j])] *
                               skin.inverseBindMatrices[j]);
    return matrices;
}

mat4x3 blend(const std::vector<mat4x3>& joints, const VertexSkin& vertex) {
    mat4x3 sum(0.0f);
    for (int c = 0; c < 4; ++c)
        if (vertex.weights[c] > 0) sum += vertex.weights[c] * joints[vertex.joints[size_t(c)]];
    return sum;
}

/// Normals go with the cofactors of the matrix, which is its inverse transposed up to the
/// determinant.
mat3 normalMatrix(const mat4x3& m) {
    const mat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return glm::dot(m[0], cofactors[0]) < 0 ? -cofactors : cofactors;
}

void applySkin(const Geometry& geometry, const std::vector<mat4x3>& joints, DeformedVertices& out) {
    for (size_t i = 0; i < out.positions.size(); ++i) {
        const mat4x3 matrix = blend(joints, geometry.skin[i]);
        out.positions[i] = transformPoint(matrix, out.positions[i]);
        out.normals[i] = unitOr(normalMatrix(matrix) * out.normals[i], out.normals[i]);
        if (out.tangents.empty()) continue;
        const vec3 tangent = transformVector(matrix, vec3(out.tangents[i]));
        out.tangents[i] = vec4(unitOr(tangent, vec3(out.tangents[i])), out.tangents[i].w);
    }
}

}  // namespace

void applySkinAndMorph(const Model& model, const Pose& pose, int node, const Geometry& geometry,
                       DeformedVertices& out) {
    out.positions = geometry.positions;
    out.normals = geometry.normals;
    out.tangents = geometry.tangents;
    const std::vector<float>& weights = pose.nodes[size_t(node)].weights;
    const size_t targets = std::min(weights.size(), geometry.morphTargets.size());
    for (size_t t = 0; t < targets; ++t)
        if (weights[t] != 0) addMorphTarget(geometry.morphTargets[t], weights[t], out);
    normalizeDirections(geometry, out);
    const int skin = model.nodes[size_t(node)].skin;
    if (skin >= 0 && !geometry.skin.empty())
        applySkin(geometry, jointMatrices(model.skins[size_t(skin)], pose), out);
}

}  // namespace rushlight::scene

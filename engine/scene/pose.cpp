#include "engine/scene/pose.h"

namespace rushlight::scene {
namespace {

using assets::Model;
using assets::Node;

mat4 localTransform(const Node& node, const NodePose& pose) {
    if (node.hasMatrix) return node.matrix;
    Node posed;
    posed.translation = pose.translation;
    posed.rotation = pose.rotation;
    posed.scale = pose.scale;
    return posed.localTransform();
}

/// Those of the node, else of the mesh, else zeros: as many as the mesh has morph targets.
std::vector<float> restWeights(const Model& model, const Node& node) {
    if (!node.weights.empty() || node.mesh < 0) return node.weights;
    const assets::Mesh& mesh = model.meshes[size_t(node.mesh)];
    if (!mesh.weights.empty() || mesh.primitives.empty()) return mesh.weights;
    const auto& geometry = model.geometries[size_t(mesh.primitives[0].geometry)];
    return std::vector<float>(geometry.morphTargets.size(), 0.0f);
}

/// Appends a node and all below it, parents first, without recursion: hierarchies may be deep.
void appendSubtree(const Model& model, int root, std::vector<int>& order) {
    const size_t first = order.size();
    order.push_back(root);
    for (size_t i = first; i < order.size(); ++i) {
        const std::vector<int>& children = model.nodes[size_t(order[i])].children;
        order.insert(order.end(), children.begin(), children.end());
    }
}

bool isSkinned(const Node& node, const assets::Geometry& geometry) {
    return node.skin >= 0 && !geometry.skin.empty();
}

}  // namespace

mat4x3 toAffine(const mat4& m) { return {vec3(m[0]), vec3(m[1]), vec3(m[2]), vec3(m[3])}; }

Pose restPose(const Model& model) {
    Pose pose;
    pose.nodes.resize(model.nodes.size());
    for (size_t i = 0; i < model.nodes.size(); ++i) {
        const Node& node = model.nodes[i];
        pose.nodes[i] = {node.translation, node.rotation, node.scale, restWeights(model, node)};
    }
    updateWorld(model, pose);
    return pose;
}

void updateWorld(const Model& model, Pose& pose) {
    pose.worldFromNode.assign(model.nodes.size(), mat4(1));
    std::vector<int> order;
    order.reserve(model.nodes.size());
    for (size_t i = 0; i < model.nodes.size(); ++i)
        if (model.nodes[i].parent < 0) appendSubtree(model, int(i), order);
    for (int index : order) {
        const Node& node = model.nodes[size_t(index)];
        const mat4 local = localTransform(node, pose.nodes[size_t(index)]);
        pose.worldFromNode[size_t(index)] = node.parent < 0
                                                ? local
                                                : pose.worldFromNode[size_t(node.parent)] * local;
    }
}

Pose poseAt(const Model& model, int animation, float seconds) {
    Pose pose = restPose(model);
    if (animation >= 0 && size_t(animation) < model.animations.size()) {
        applyAnimation(model, model.animations[size_t(animation)], seconds, pose);
        updateWorld(model, pose);
    }
    return pose;
}

std::vector<int> reachableNodes(const Model& model) {
    std::vector<int> order;
    for (int root : model.roots) appendSubtree(model, root, order);
    return order;
}

std::vector<Drawable> listDrawables(const Model& model, const Pose& pose) {
    std::vector<Drawable> drawables;
    for (int index : reachableNodes(model)) {
        const Node& node = model.nodes[size_t(index)];
        if (node.mesh < 0) continue;
        const auto& primitives = model.meshes[size_t(node.mesh)].primitives;
        for (size_t p = 0; p < primitives.size(); ++p) {
            const assets::Geometry& geometry = model.geometries[size_t(primitives[p].geometry)];
            Drawable drawable;
            drawable.node = index;
            drawable.primitive = int(p);
            drawable.geometry = primitives[p].geometry;
            drawable.material = primitives[p].material;
            const bool skinned = isSkinned(node, geometry);
            drawable.deforms = skinned || !geometry.morphTargets.empty();
            if (!skinned) drawable.worldFromLocal = toAffine(pose.worldFromNode[size_t(index)]);
            drawables.push_back(drawable);
        }
    }
    return drawables;
}

}  // namespace rushlight::scene

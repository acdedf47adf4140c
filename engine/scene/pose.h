#pragma once
// Where the nodes of a model are at a moment, and what is to be drawn there.

#include "engine/assets/model.h"
#include "engine/core/math.h"

#include <vector>

namespace rushlight::scene {

/// The part of a node that animations change.
struct NodePose {
    vec3 translation{0};
    quat rotation{1, 0, 0, 0};
    vec3 scale{1};
    std::vector<float> weights;  ///< of the morph targets; empty: the mesh has none
};

/// One moment of a model. `worldFromNode` is as long as Model::nodes, whether a scene reaches them
/// or not.
struct Pose {
    std::vector<NodePose> nodes;
    std::vector<mat4> worldFromNode;
};

/// The pose the file stores, with its world matrices.
Pose restPose(const assets::Model& model);

/// Overwrites in `pose` what the animation animates, at `seconds` (held before its first key and
/// after its last). Call updateWorld afterwards.
void applyAnimation(const assets::Model& model, const assets::Animation& animation, float seconds,
                    Pose& pose);

/// Computes worldFromNode, parents before children.
void updateWorld(const assets::Model& model, Pose& pose);

/// restPose, applyAnimation unless `animation` is -1, updateWorld.
Pose poseAt(const assets::Model& model, int animation, float seconds);

/// A primitive to draw. A skinned one is deformed into world space, so its transform is the
/// identity.
struct Drawable {
    int node = -1;
    int primitive = 0;  ///< into Mesh::primitives of the node's mesh
    int geometry = -1;
    int material = -1;
    bool deforms = false;  ///< has a skin or morph targets: see applySkinAndMorph
    mat4x3 worldFromLocal{1.0f};
};

/// The drawables of all nodes that Model::roots reach, parents first.
std::vector<Drawable> listDrawables(const assets::Model& model, const Pose& pose);

/// The nodes that Model::roots reach, parents first.
std::vector<int> reachableNodes(const assets::Model& model);

/// For instances: the affine part of a transform.
mat4x3 toAffine(const mat4& m);

}  // namespace rushlight::scene

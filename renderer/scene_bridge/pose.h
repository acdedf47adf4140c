#pragma once
// Where the nodes of a model are at a moment of an animation. glTF 2.0, sections 3.5 and 3.11,
// appendix C.

#include "engine/assets/model.h"

#include <vector>

namespace rushlight {

/// The moving part of a node.
struct NodePose {
    vec3 translation{0};
    quat rotation{1, 0, 0, 0};
    vec3 scale{1};
    std::vector<float> weights;  ///< of the morph targets; empty when the mesh has none
};

/// The pose of the file, with the channels of `animation` at `seconds` when it is not null. Outside
/// of its keys a channel holds its first or last value.
std::vector<NodePose> poseAt(const assets::Model&, const assets::Animation* animation,
                             float seconds);

/// World matrices by node; of nodes outside the shown scene the identity.
std::vector<mat4> worldTransforms(const assets::Model&, const std::vector<NodePose>&);

/// The nodes of the shown scene, parents first.
std::vector<int> shownNodes(const assets::Model&);

}  // namespace rushlight

#include "renderer/scene_bridge/pose.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

using assets::AnimationChannel;
using assets::AnimationPath;
using assets::Interpolation;

/// A moment between two keys: 0 at `key`, 1 at the next one.
struct KeySpan {
    size_t key = 0;
    float at = 0;
    float seconds = 0;  ///< from one key to the next; 0 outside of the keys
};

KeySpan findKeys(const std::vector<float>& times, float seconds) {
    if (seconds <= times.front()) return {0, 0, 0};
    if (seconds >= times.back()) return {times.size() - 1, 0, 0};
    const auto next = std::ranges::upper_bound(times, seconds);
    const size_t key = size_t(next - times.begin()) - 1;
    const float length = times[key + 1] - times[key];
    return {key, (seconds - times[key]) / length, length};
}

size_t componentCount(const AnimationChannel& channel) {
    const size_t tripled = channel.interpolation == Interpolation::cubicSpline ? 3 : 1;
    return channel.values.size() / (channel.times.size() * tripled);
}

/// Appendix C.5: keys are in-tangent, value, out-tangent.
float cubicValue(const AnimationChannel& channel, const KeySpan& span, size_t n, size_t c) {
    const auto value = [&](size_t key, size_t part) {
        return channel.values[(key * 3 + part) * n + c];
    };
    if (span.seconds == 0) return value(span.key, 1);
    const float t = span.at;
    const float t2 = t * t;
    const float t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * value(span.key, 1) +
           span.seconds * (t3 - 2 * t2 + t) * value(span.key, 2) +
           (3 * t2 - 2 * t3) * value(span.key + 1, 1) +
           span.seconds * (t3 - t2) * value(span.key + 1, 0);
}

std::vector<float> componentsAt(const AnimationChannel& channel, const KeySpan& span) {
    const size_t n = componentCount(channel);
    std::vector<float> result(n);
    const bool blend = channel.interpolation == Interpolation::linear && span.seconds > 0;
    for (size_t c = 0; c < n; ++c) {
        if (channel.interpolation == Interpolation::cubicSpline) {
            result[c] = cubicValue(channel, span, n, c);
            continue;
        }
        result[c] = channel.values[span.key * n + c];
        if (blend) result[c] += span.at * (channel.values[(span.key + 1) * n + c] - result[c]);
    }
    return result;
}

quat keyRotation(const AnimationChannel& channel, size_t key) {
    const float* v = channel.values.data() + key * 4;
    return glm::normalize(quat(v[3], v[0], v[1], v[2]));
}

quat rotationAt(const AnimationChannel& channel, const KeySpan& span) {
    if (channel.interpolation == Interpolation::linear && span.seconds > 0)
        return glm::slerp(keyRotation(channel, span.key), keyRotation(channel, span.key + 1),
                          span.at);
    const auto v = componentsAt(channel, span);
    return glm::normalize(quat(v[3], v[0], v[1], v[2]));
}

void apply(const AnimationChannel& channel, float seconds, NodePose& pose) {
    const KeySpan span = findKeys(channel.times, seconds);
    if (channel.path == AnimationPath::rotation) {
        pose.rotation = rotationAt(channel, span);
        return;
    }
    std::vector<float> v = componentsAt(channel, span);
    switch (channel.path) {
        case AnimationPath::translation: pose.translation = {v[0], v[1], v[2]}; break;
        case AnimationPath::scale: pose.scale = {v[0], v[1], v[2]}; break;
        case AnimationPath::weights: pose.weights = std::move(v); break;
        case AnimationPath::rotation: break;
    }
}

mat4 localTransform(const assets::Node& node, const NodePose& pose) {
    if (node.hasMatrix) return node.matrix;  // such a node is not animated (section 3.5.3)
    mat4 m = glm::mat4_cast(pose.rotation);
    for (int axis = 0; axis < 3; ++axis) m[axis] *= pose.scale[axis];
    m[3] = vec4(pose.translation, 1);
    return m;
}

}  // namespace

std::vector<NodePose> poseAt(const assets::Model& model, const assets::Animation* animation,
                             float seconds) {
    std::vector<NodePose> poses(model.nodes.size());
    for (size_t i = 0; i < poses.size(); ++i) {
        const assets::Node& node = model.nodes[i];
        poses[i] = {node.translation, node.rotation, node.scale, node.weights};
        if (poses[i].weights.empty() && node.mesh >= 0)
            poses[i].weights = model.meshes[size_t(node.mesh)].weights;
    }
    if (animation)
        for (const AnimationChannel& channel : animation->channels)
            if (channel.node >= 0 && !channel.times.empty())
                apply(channel, seconds, poses[size_t(channel.node)]);
    return poses;
}

std::vector<int> shownNodes(const assets::Model& model) {
    std::vector<int> nodes = model.roots;
    for (size_t i = 0; i < nodes.size(); ++i) {
        const auto& children = model.nodes[size_t(nodes[i])].children;
        nodes.insert(nodes.end(), children.begin(), children.end());
    }
    return nodes;
}

std::vector<mat4> worldTransforms(const assets::Model& model, const std::vector<NodePose>& poses) {
    std::vector<mat4> world(model.nodes.size(), mat4(1));
    for (int index : shownNodes(model)) {
        const assets::Node& node = model.nodes[size_t(index)];
        const mat4 local = localTransform(node, poses[size_t(index)]);
        world[size_t(index)] = node.parent >= 0 ? world[size_t(node.parent)] * local : local;
    }
    return world;
}

}  // namespace rushlight

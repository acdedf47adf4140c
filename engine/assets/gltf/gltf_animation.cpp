#include "engine/assets/gltf/gltf_builder.h"
#include "engine/assets/input_error.h"

#include <algorithm>

namespace rushlight::assets {
namespace {

AnimationPath toPath(const std::string& path) {
    if (path == "rotation") return AnimationPath::rotation;
    if (path == "scale") return AnimationPath::scale;
    return path == "weights" ? AnimationPath::weights : AnimationPath::translation;
}

Interpolation toInterpolation(const std::string& name) {
    if (name == "STEP") return Interpolation::step;
    return name == "CUBICSPLINE" ? Interpolation::cubicSpline : Interpolation::linear;
}

bool isFloat(const tinygltf::Accessor& accessor, int type) {
    return accessor.type == type && accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
}

/// Floats, or normalised small integers for rotation and weights (glTF 2.0, section 3.11).
bool isAllowedOutput(const tinygltf::Accessor& accessor, AnimationPath path) {
    const int type = path == AnimationPath::weights    ? TINYGLTF_TYPE_SCALAR
                     : path == AnimationPath::rotation ? TINYGLTF_TYPE_VEC4
                                                       : TINYGLTF_TYPE_VEC3;
    if (accessor.type != type) return false;
    if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT) return true;
    return accessor.normalized && accessor.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT &&
           (path == AnimationPath::weights || path == AnimationPath::rotation);
}

/// The fourth row of an inverse bind matrix must be 0 0 0 1 (glTF 2.0, section 3.7.3.1), up to
/// rounding.
bool isAffine(const mat4& m) {
    const vec4 row(m[0].w, m[1].w, m[2].w, m[3].w);
    return glm::all(glm::lessThan(glm::abs(row - vec4(0, 0, 0, 1)), vec4(1e-4f)));
}

int largestJoint(const Geometry& geometry) {
    int largest = -1;
    for (const VertexSkin& vertex : geometry.skin)
        for (int c = 0; c < 4; ++c)
            if (vertex.weights[c] > 0) largest = std::max(largest, int(vertex.joints[size_t(c)]));
    return largest;
}

}  // namespace

void GltfBuilder::buildSkins() {
    for (const tinygltf::Skin& source : gltf_.skins) {
        const std::string what = numbered("skin", model_.skins.size(), source.name);
        Skin skin;
        skin.name = source.name;
        skin.joints = source.joints;
        skin.inverseBindMatrices.assign(skin.joints.size(), mat4(1));
        if (source.inverseBindMatrices >= 0) {
            const tinygltf::Accessor& accessor = reader_.get(source.inverseBindMatrices);
            if (!isFloat(accessor, TINYGLTF_TYPE_MAT4))
                refuse(what + ": its inverse bind matrices are not 4 x 4 floats.");
            if (accessor.count < skin.joints.size())
                refuse(what + ": it has " + std::to_string(skin.joints.size()) +
                       " joints but only " + std::to_string(accessor.count) +
                       " inverse bind matrices.");
            const std::vector<float> flat = reader_.floats(source.inverseBindMatrices);
            for (size_t j = 0; j < skin.joints.size(); ++j)
                for (int i = 0; i < 16; ++i)
                    skin.inverseBindMatrices[j][i / 4][i % 4] = flat[j * 16 + size_t(i)];
            for (size_t j = 0; j < skin.joints.size(); ++j)
                if (accessor.bufferView >= 0 && !isAffine(skin.inverseBindMatrices[j]))
                    refuse(what + ": the fourth row of inverse bind matrix " + std::to_string(j) +
                           " is not 0 0 0 1.");
        }
        model_.skins.push_back(std::move(skin));
    }
}

void GltfBuilder::checkSkinnedNodes() const {
    std::vector<int> largest(model_.geometries.size());
    for (size_t i = 0; i < largest.size(); ++i) largest[i] = largestJoint(model_.geometries[i]);
    for (size_t i = 0; i < model_.nodes.size(); ++i) {
        const Node& node = model_.nodes[i];
        if (node.skin < 0 || node.mesh < 0) continue;
        const size_t joints = model_.skins[size_t(node.skin)].joints.size();
        for (const Primitive& primitive : model_.meshes[size_t(node.mesh)].primitives)
            if (largest[size_t(primitive.geometry)] >= int(joints))
                refuse(numbered("node", i, node.name) + ": its mesh uses joint " +
                       std::to_string(largest[size_t(primitive.geometry)]) + " but skin " +
                       std::to_string(node.skin) + " has " + std::to_string(joints) + " joints.");
    }
}

AnimationChannel GltfBuilder::buildChannel(const tinygltf::Animation& animation,
                                           const tinygltf::AnimationChannel& source,
                                           const std::string& what) {
    const tinygltf::AnimationSampler& sampler = animation.samplers[size_t(source.sampler)];
    AnimationChannel channel;
    channel.node = source.target_node;
    channel.path = toPath(source.target_path);
    channel.interpolation = toInterpolation(sampler.interpolation);
    if (!isFloat(reader_.get(sampler.input), TINYGLTF_TYPE_SCALAR))
        refuse(what + ": its times are not floats.");
    if (!isAllowedOutput(reader_.get(sampler.output), channel.path))
        refuse(what + ": its values have a type that " + source.target_path + " may not have.");
    channel.times = reader_.floats(sampler.input);
    channel.values = reader_.floats(sampler.output);
    for (size_t i = 0; i < channel.times.size(); ++i)
        if (channel.times[i] < 0 || (i > 0 && channel.times[i] <= channel.times[i - 1]))
            refuse(what + ": its times are not increasing from 0 on at key " + std::to_string(i) +
                   ".");
    size_t components = channel.path == AnimationPath::rotation ? 4 : 3;
    if (channel.path == AnimationPath::weights) {
        const int mesh = gltf_.nodes[size_t(channel.node)].mesh;
        components = gltf_.meshes[size_t(mesh)].primitives[0].targets.size();
        if (components == 0) refuse(what + ": the mesh it animates has no morph targets.");
    }
    const bool cubic = channel.interpolation == Interpolation::cubicSpline;
    const size_t expected = channel.times.size() * components * (cubic ? 3 : 1);
    if (channel.values.size() != expected)
        refuse(what + ": it has " + std::to_string(channel.values.size()) + " numbers instead of " +
               std::to_string(expected) + " for its " + std::to_string(channel.times.size()) +
               " keys.");
    if (cubic && channel.times.size() < 2)
        refuse(what + ": a cubic spline needs at least two keys.");
    return channel;
}

void GltfBuilder::buildAnimations() {
    for (const tinygltf::Animation& source : gltf_.animations) {
        const std::string name = numbered("animation", model_.animations.size(), source.name);
        Animation animation;
        animation.name = source.name;
        for (size_t i = 0; i < source.channels.size(); ++i) {
            const std::string what = name + " " + numbered("channel", i);
            if (source.channels[i].target_node < 0) {
                unsupported(what + ": a target that is no node");
                continue;
            }
            AnimationChannel channel = buildChannel(source, source.channels[i], what);
            animation.duration = std::max(animation.duration, channel.times.back());
            animation.channels.push_back(std::move(channel));
        }
        model_.animations.push_back(std::move(animation));
    }
}

}  // namespace rushlight::assets

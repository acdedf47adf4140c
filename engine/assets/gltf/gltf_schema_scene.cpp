// Nodes, skins, animations.
#include "engine/assets/gltf/gltf_schema_parts.h"

#include <cfloat>
#include <cmath>
#include <set>

namespace rushlight::assets {
namespace {

void checkTransform(const JsonObject& node) {
    node.numbers("matrix", 16, -FLT_MAX, FLT_MAX);
    node.numbers("translation", 3, -FLT_MAX, FLT_MAX);
    node.numbers("scale", 3, -FLT_MAX, FLT_MAX);
    node.numbers("rotation", 4, -1, 1);
    const bool hasParts = node.has("translation") || node.has("rotation") || node.has("scale");
    if (node.has("matrix") && hasParts)
        node.wrong("it has both a matrix and a translation, rotation or scale.");
    if (!node.has("rotation")) return;
    double squares = 0;
    for (const Json& part : node.json()["rotation"]) squares += std::pow(part.get<double>(), 2);
    if (std::abs(std::sqrt(squares) - 1) > 0.01)
        node.wrong("its rotation is a quaternion of length " + std::to_string(std::sqrt(squares)) +
                   " instead of 1.");
}

void checkInstancing(const Counts& counts, const JsonObject& node) {
    const Json* json = findExtension(node, "EXT_mesh_gpu_instancing");
    if (!json) return;
    const JsonObject extension(*json, node.what() + " EXT_mesh_gpu_instancing");
    if (const Json* attributes = extension.object("attributes"))
        for (const auto& [name, value] : attributes->items())
            JsonObject(*attributes, extension.what()).index(name.c_str(), counts.accessors);
}

void checkSampler(const Counts& counts, const JsonObject& sampler) {
    sampler.index("input", counts.accessors, Need::required);
    sampler.index("output", counts.accessors, Need::required);
    sampler.oneOf("interpolation", {"LINEAR", "STEP", "CUBICSPLINE"});
}

void checkTarget(const Counts& counts, const JsonObject& root, const JsonObject& target) {
    const int64_t node = target.index("node", counts.nodes);
    target.text("path", Need::required);
    if (!findExtension(target, "KHR_animation_pointer"))
        target.oneOf("path", {"translation", "rotation", "scale", "weights"}, Need::required);
    if (node < 0) return;
    const bool isWeights = target.json()["path"].get_ref<const std::string&>() == "weights";
    const Json& animated = root.json()["nodes"][size_t(node)];
    if (animated.contains("matrix") && !isWeights)
        target.wrong("it animates node " + std::to_string(node) + ", which has a matrix.");
    if (isWeights && !animated.contains("mesh"))
        target.wrong("it animates the weights of node " + std::to_string(node) +
                     ", which has no mesh.");
}

}  // namespace

void checkNodes(const Counts& counts, const JsonObject& root) {
    forEach(root, "nodes", "node", [&](const JsonObject& node) {
        const int64_t mesh = node.index("mesh", counts.meshes);
        const int64_t skin = node.index("skin", counts.skins);
        node.index("camera", counts.cameras);
        node.indices("children", counts.nodes);
        node.numbers("weights", 0, -FLT_MAX, FLT_MAX);
        if (skin >= 0 && mesh < 0) node.wrong("it has a skin but no mesh.");
        if (node.has("weights") && mesh < 0) node.wrong("it has weights but no mesh.");
        checkTransform(node);
        checkReflectionProbe(node);
        checkAreaLight(node);
        if (const Json* json = findExtension(node, "KHR_lights_punctual"))
            JsonObject(*json, node.what() + " KHR_lights_punctual")
                .index("light", counts.lights, Need::required);
        checkNodeProfile(counts, node);
        checkLightExtras(counts, node);
        checkInstancing(counts, node);
    });
}

void checkSkins(const Counts& counts, const JsonObject& root) {
    forEach(root, "skins", "skin", [&](const JsonObject& skin) {
        skin.indices("joints", counts.nodes, Need::required);
        skin.index("skeleton", counts.nodes);
        skin.index("inverseBindMatrices", counts.accessors);
        if (skin.json()["joints"].size() > 65535) skin.wrong("it has more than 65,535 joints.");
    });
}

void checkAnimations(const Counts& counts, const JsonObject& root) {
    forEach(root, "animations", "animation", [&](const JsonObject& animation) {
        const std::string prefix = animation.what() + " ";
        forEach(
            animation, "samplers", "sampler",
            [&](const JsonObject& sampler) { checkSampler(counts, sampler); }, Need::required,
            prefix);
        const size_t samplers = animation.json()["samplers"].size();
        std::set<std::string> targets;
        forEach(
            animation, "channels", "channel",
            [&](const JsonObject& channel) {
                channel.index("sampler", samplers, Need::required);
                const JsonObject target(*channel.object("target", Need::required),
                                        channel.what() + " target");
                checkTarget(counts, root, target);
                const int64_t node = target.json().value("node", int64_t(-1));
                const std::string key = target.json()["path"].get<std::string>() + " " +
                                        std::to_string(node);
                if (node >= 0 && !targets.insert(key).second)
                    channel.wrong("another channel animates the same property of node " +
                                  std::to_string(node) + ".");
            },
            Need::required, prefix);
    });
}

}  // namespace rushlight::assets

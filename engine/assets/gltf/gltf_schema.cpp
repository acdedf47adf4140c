#include "engine/assets/gltf/gltf_schema.h"

#include "engine/assets/gltf/gltf_schema_parts.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>

namespace rushlight::assets {
namespace {

constexpr std::array<const char*, 13> kArrays = {
    "accessors", "animations", "buffers",  "bufferViews", "cameras", "images",  "materials",
    "meshes",    "nodes",      "samplers", "scenes",      "skins",   "textures"};

/// What loadModel does, exactly or as far as the picture is concerned; anything else required is
/// refused.
constexpr std::array<std::string_view, 12> kSupported = {
    "KHR_lights_punctual",     "KHR_texture_transform",      "KHR_materials_emissive_strength",
    "KHR_materials_unlit",     "KHR_mesh_quantization",      "EXT_texture_webp",
    "EXT_mesh_gpu_instancing", "EXT_meshopt_compression",    "EXT_lights_ies",
    "EXT_lights_image_based",  "KHR_materials_transmission", "KHR_materials_volume"};

void checkAsset(const JsonObject& root) {
    const JsonObject asset(*root.object("asset", Need::required), "asset");
    asset.text("version", Need::required);
    asset.text("minVersion");
    asset.text("generator");
    asset.text("copyright");
    for (const char* key : {"version", "minVersion"}) {
        if (!asset.has(key)) continue;
        const std::string version = asset.json()[key].get<std::string>();
        const size_t dot = version.find('.');
        const auto isNumber = [](const std::string& text) {
            return !text.empty() && text.size() < 6 &&
                   text.find_first_not_of("0123456789") == std::string::npos;
        };
        if (dot == std::string::npos || !isNumber(version.substr(0, dot)) ||
            !isNumber(version.substr(dot + 1)))
            asset.wrong(std::string("its ") + key + " '" + version + "' is not of the form 2.0.");
        const int major = std::atoi(version.c_str());
        const int minor = std::atoi(version.c_str() + dot + 1);
        const bool tooNew = key == std::string_view("minVersion") && (major != 2 || minor > 0);
        if (major != 2 || tooNew)
            asset.wrong(std::string("its ") + key + " is " + version + "; glTF 2.0 can be read.");
    }
    if (asset.has("minVersion") &&
        asset.json()["minVersion"].get<std::string>() > asset.json()["version"].get<std::string>())
        asset.wrong("its minVersion is above its version.");
}

void checkExtensionList(const JsonObject& root, const char* key) {
    const Json* names = root.array(key);
    if (!names) return;
    std::set<std::string> seen;
    for (const Json& name : *names) {
        if (!name.is_string()) root.wrong(std::string(key) + " holds something else than strings.");
        if (!seen.insert(name.get<std::string>()).second)
            root.wrong(std::string(key) + " names " + name.dump() + " twice.");
    }
}

void checkExtensions(const JsonObject& root) {
    checkExtensionList(root, "extensionsUsed");
    checkExtensionList(root, "extensionsRequired");
    if (!root.has("extensionsRequired")) return;
    for (const Json& name : root.json()["extensionsRequired"]) {
        const auto required = name.get<std::string>();
        if (!isSupportedExtension(required))
            refuse("uses " + required + ", which is not supported.");
        const Json used = root.json().value("extensionsUsed", Json::array());
        if (std::find(used.begin(), used.end(), name) == used.end())
            refuse("it requires " + required + " but extensionsUsed does not name it.");
    }
}

/// No node has two parents and none is its own ancestor. Returns each node's parent.
std::vector<int64_t> checkHierarchy(const Counts& counts, const Json& gltf) {
    std::vector<int64_t> parent(counts.nodes, -1);
    for (size_t i = 0; i < counts.nodes; ++i) {
        const Json& node = gltf["nodes"][i];
        for (const Json& child : node.value("children", Json::array())) {
            const size_t c = child.get<size_t>();
            if (parent[c] >= 0)
                refuse(nameOf("node", c, gltf["nodes"][c]) + ": both node " +
                       std::to_string(parent[c]) + " and node " + std::to_string(i) +
                       " have it as a child.");
            parent[c] = int64_t(i);
        }
    }
    // Following parents from a node in a cycle never ends; marks make the walk linear over all
    // nodes.
    std::vector<size_t> seenFrom(counts.nodes, counts.nodes);
    for (size_t i = 0; i < counts.nodes; ++i)
        for (int64_t at = int64_t(i); at >= 0 && seenFrom[size_t(at)] != i;) {
            if (seenFrom[size_t(at)] != counts.nodes) break;
            seenFrom[size_t(at)] = i;
            at = parent[size_t(at)];
            if (at >= 0 && seenFrom[size_t(at)] == i)
                refuse(nameOf("node", size_t(at), gltf["nodes"][size_t(at)]) +
                       ": it is its own ancestor.");
        }
    return parent;
}

void checkScenes(const Counts& counts, const JsonObject& root, const std::vector<int64_t>& parent) {
    root.index("scene", counts.scenes);
    forEach(root, "scenes", "scene", [&](const JsonObject& scene) {
        scene.indices("nodes", counts.nodes);
        checkImageBasedLightOf(scene, counts.imageBasedLights);
        for (const Json& node : scene.json().value("nodes", Json::array()))
            if (parent[node.get<size_t>()] >= 0)
                scene.wrong("its node " + node.dump() + " is no root: node " +
                            std::to_string(parent[node.get<size_t>()]) + " is its parent.");
    });
}

Counts countArrays(const JsonObject& root) {
    const auto size = [&](const char* key) {
        const Json* array = root.array(key);
        return array ? array->size() : size_t(0);
    };
    for (const char* key : kArrays) size(key);
    Counts counts;
    counts.accessors = size("accessors");
    counts.buffers = size("buffers");
    counts.bufferViews = size("bufferViews");
    counts.cameras = size("cameras");
    counts.images = size("images");
    counts.materials = size("materials");
    counts.meshes = size("meshes");
    counts.nodes = size("nodes");
    counts.samplers = size("samplers");
    counts.scenes = size("scenes");
    counts.skins = size("skins");
    counts.textures = size("textures");
    return counts;
}

}  // namespace

bool isSupportedExtension(std::string_view name) {
    return std::find(kSupported.begin(), kSupported.end(), name) != kSupported.end();
}

void checkSchema(const Json& gltf) {
    const JsonObject root(gltf, "the glTF");
    checkAsset(root);
    checkExtensions(root);
    Counts counts = countArrays(root);
    counts.lightProfiles = checkLightProfiles(counts, root);
    counts.lights = checkLights(counts, root);
    counts.imageBasedLights = checkImageBasedLights(counts, root);
    checkBuffers(counts, root);
    checkAccessors(counts, root);
    checkTextures(counts, root);
    checkMaterials(counts, root);
    checkMeshes(counts, root);
    checkCameras(root);
    checkNodes(counts, root);
    checkSkins(counts, root);
    checkAnimations(counts, root);
    checkScenes(counts, root, checkHierarchy(counts, gltf));
}

}  // namespace rushlight::assets

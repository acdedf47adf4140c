#include "engine/assets/gltf.h"
#include "sandbox/tool/command.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace rushlight::tool {
namespace {

using nlohmann::ordered_json;

/// What the scene draws: a primitive counts once for every node that shows it.
struct Budget {
    uint64_t instances = 0;
    uint64_t triangles = 0;
    uint64_t uniqueTriangles = 0;
    uint64_t vertices = 0;
    uint64_t textureBytes = 0;  ///< RGBA8 with mip levels
};

Budget budgetOf(const assets::Model& model) {
    Budget budget;
    for (const assets::Geometry& geometry : model.geometries) {
        budget.uniqueTriangles += geometry.indices.size() / 3;
        budget.vertices += geometry.positions.size();
    }
    for (const assets::Image& image : model.images)
        for (uint32_t w = image.width, h = image.height; w > 0 && h > 0;
             w = w == 1 && h == 1 ? 0 : std::max(w / 2, 1u), h = std::max(h / 2, 1u))
            budget.textureBytes += uint64_t(w) * h * 4;
    std::vector<int> nodes = model.roots;
    for (size_t i = 0; i < nodes.size(); ++i) {
        const assets::Node& node = model.nodes[size_t(nodes[i])];
        nodes.insert(nodes.end(), node.children.begin(), node.children.end());
        if (node.mesh < 0) continue;
        for (const assets::Primitive& primitive : model.meshes[size_t(node.mesh)].primitives) {
            ++budget.instances;
            if (primitive.geometry >= 0)
                budget.triangles += model.geometries[size_t(primitive.geometry)].indices.size() / 3;
        }
    }
    return budget;
}

const char* toText(assets::LightType type) {
    switch (type) {
        case assets::LightType::directional: return "directional";
        case assets::LightType::point: return "point";
        case assets::LightType::spot: return "spot";
    }
    return "unknown";
}

ordered_json describe(const assets::Model& model) {
    const Budget budget = budgetOf(model);
    ordered_json json = {{"file", model.path},
                         {"generator", model.generator},
                         {"nodes", model.nodes.size()},
                         {"instances", budget.instances},
                         {"triangles", budget.triangles},
                         {"unique_triangles", budget.uniqueTriangles},
                         {"vertices", budget.vertices},
                         {"geometries", model.geometries.size()},
                         {"meshes", model.meshes.size()},
                         {"materials", model.materials.size()},
                         {"images", model.images.size()},
                         {"texture_bytes", budget.textureBytes},
                         {"skins", model.skins.size()}};
    json["cameras"] = ordered_json::array();
    for (const assets::Camera& camera : model.cameras)
        json["cameras"].push_back({{"name", camera.name}, {"perspective", camera.perspective}});
    json["lights"] = ordered_json::array();
    for (const assets::Light& light : model.lights)
        json["lights"].push_back({{"name", light.name},
                                  {"type", toText(light.type)},
                                  {"intensity", light.intensity},
                                  {"range", light.range}});
    json["animations"] = ordered_json::array();
    for (const assets::Animation& animation : model.animations)
        json["animations"].push_back({{"name", animation.name},
                                      {"seconds", animation.duration},
                                      {"channels", animation.channels.size()}});
    json["fidelity"] = {{"exact", model.fidelity.exact},
                        {"approximated", model.fidelity.approximated},
                        {"unsupported", model.fidelity.unsupported}};
    return json;
}

void printList(const char* title, const ordered_json& list) {
    if (list.empty()) return;
    std::printf("%s\n", title);
    for (const auto& item : list) {
        if (item.is_string()) {
            std::printf("  %s\n", item.get<std::string>().c_str());
            continue;
        }
        std::string line;
        for (const auto& [key, value] : item.items())
            line += (line.empty() ? "" : ", ") + key + " " + value.dump();
        std::printf("  %s\n", line.c_str());
    }
}

void printText(const ordered_json& json) {
    for (const auto& [key, value] : json.items())
        if (value.is_string())
            std::printf("%-17s %s\n", key.c_str(), value.get<std::string>().c_str());
        else if (value.is_number())
            std::printf("%-17s %s\n", key.c_str(), value.dump().c_str());
    for (const char* key : {"cameras", "lights", "animations"}) printList(key, json[key]);
    for (const char* key : {"exact", "approximated", "unsupported"})
        printList(key, json["fidelity"][key]);
}

Result<int> info(const std::string& scene, bool asJson, bool strict) {
    assets::LoadOptions options;
    options.strict = strict;
    const auto model = assets::loadModel(scene, options);
    if (!model) return tl::unexpected(model.error());
    for (const std::string& warning : model->warnings) printWarning(warning);
    const ordered_json json = describe(*model);
    if (asJson)
        // Names come from the file and may be no UTF-8.
        std::printf("%s\n",
                    json.dump(2, ' ', false, ordered_json::error_handler_t::replace).c_str());
    else
        printText(json);
    return kSuccess;
}

struct InfoArguments {
    std::string scene;
    bool json = false;
    bool strict = false;
};

}  // namespace

void addInfo(CLI::App& app, Action& action) {
    auto arguments = std::make_shared<InfoArguments>();
    CLI::App* command = app.add_subcommand(
        "info", "What is in a file, its budget, and how exactly it is shown");
    command->add_option("SCENE", arguments->scene, "A .gltf or .glb file")->required();
    command->add_flag("--json", arguments->json, "Print JSON instead of text");
    command->add_flag("--strict", arguments->strict,
                      "What is approximated or unsupported is an error");
    command->callback([&action, arguments] {
        action = [arguments] { return info(arguments->scene, arguments->json, arguments->strict); };
    });
}

}  // namespace rushlight::tool

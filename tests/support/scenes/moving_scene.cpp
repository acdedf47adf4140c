#include "tests/support/scenes/moving_scene.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace rushlight {

using Json = nlohmann::json;

void writeMovingScene(const std::string& testcard, const std::string& folder) {
    std::filesystem::copy(testcard, folder);
    Json gltf = Json::parse(std::ifstream(folder + "/testcard.gltf"));
    const float times[] = {0, 1.5f, 3};
    const float paths[3][9] = {{0, 2.2f, 7.4f, 0, 8, 40, 0, 2.2f, 7.4f},
                               {-2.9f, 1.9f, 1.4f, 2.9f, 1.9f, 1.4f, -2.9f, 2.5f, 1},
                               {0, 0.42f, -0.5f, 0, 1.5f, 2, 0, 0.42f, -0.5f}};
    const int nodes[] = {0, 2, 9};
    std::string bytes(reinterpret_cast<const char*>(times), sizeof times);
    bytes.append(reinterpret_cast<const char*>(paths), sizeof paths);
    std::ofstream binary(folder + "/moving.bin", std::ios::binary);
    if (!(binary << bytes).flush()) std::abort();

    const size_t buffer = gltf["buffers"].size(), firstAccessor = gltf["accessors"].size();
    gltf["buffers"].push_back({{"uri", "moving.bin"}, {"byteLength", bytes.size()}});
    const auto add = [&](size_t offset, size_t size, const char* type) {
        gltf["bufferViews"].push_back(
            {{"buffer", buffer}, {"byteOffset", offset}, {"byteLength", size}});
        gltf["accessors"].push_back({{"bufferView", gltf["bufferViews"].size() - 1},
                                     {"componentType", 5126},
                                     {"count", 3},
                                     {"type", type}});
    };
    add(0, sizeof times, "SCALAR");
    gltf["accessors"].back()["min"] = {0};
    gltf["accessors"].back()["max"] = {3};
    Json animation;
    for (size_t i = 0; i < 3; ++i) {
        add(sizeof times + i * sizeof paths[0], sizeof paths[0], "VEC3");
        animation["samplers"].push_back(
            {{"input", firstAccessor}, {"output", firstAccessor + 1 + i}});
        animation["channels"].push_back(
            {{"sampler", i}, {"target", {{"node", nodes[i]}, {"path", "translation"}}}});
    }
    gltf["animations"].push_back(animation);
    std::ofstream text(folder + "/moving.gltf");
    if (!(text << gltf.dump()).flush()) std::abort();
}

}  // namespace rushlight

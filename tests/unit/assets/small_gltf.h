#pragma once
// Small glTF files that tests write and break.

#include "engine/assets/gltf.h"

#include <nlohmann/json.hpp>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rushlight::test {

using Json = nlohmann::json;

/// A folder of its own per test, removed afterwards.
class TempFolder {
public:
    TempFolder() {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        path_ = std::filesystem::temp_directory_path() /
                (std::string("rushlight_") + info->test_suite_name() + "_" + info->name());
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~TempFolder() { std::filesystem::remove_all(path_); }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << bytes;
        return path_ / name;
    }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// A glTF with one buffer that grows with every accessor.
struct SmallGltf {
    Json json = Json::parse(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":0}]})");
    std::string bytes;

    /// Appends a buffer view and an accessor of it; returns the accessor's index.
    template <class T>
    int add(const std::vector<T>& values, int componentType, const char* type, int components) {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        const size_t size = values.size() * sizeof(T);
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}});
        bytes.append(reinterpret_cast<const char*>(values.data()), size);
        json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                     {"componentType", componentType},
                                     {"count", values.size() / size_t(components)},
                                     {"type", type}});
        return int(json["accessors"].size()) - 1;
    }

    /// POSITION, with the bounds that it must declare.
    int addPositions(const std::vector<float>& values) {
        const int accessor = add(values, 5126, "VEC3", 3);
        std::vector<float> low(values.begin(), values.begin() + 3), high = low;
        for (size_t i = 0; i < values.size(); ++i) {
            low[i % 3] = std::min(low[i % 3], values[i]);
            high[i % 3] = std::max(high[i % 3], values[i]);
        }
        json["accessors"][size_t(accessor)]["min"] = low;
        json["accessors"][size_t(accessor)]["max"] = high;
        return accessor;
    }

    std::filesystem::path save(const TempFolder& folder, const std::string& name = "a.gltf") {
        json["buffers"][0]["byteLength"] = bytes.empty() ? 4 : bytes.size();
        if (!json["buffers"][0].contains("uri")) json["buffers"][0]["uri"] = "a.bin";
        folder.write("a.bin", bytes.empty() ? "0000" : bytes);
        return folder.write(name, json.dump());
    }

    std::string glb(uint32_t version = 2) const {
        std::string text = json.dump(), bin = bytes;
        text.resize((text.size() + 3) / 4 * 4, ' ');
        bin.resize((bin.size() + 3) / 4 * 4);
        const auto word = [](size_t value) {
            const uint32_t v = uint32_t(value);
            return std::string(reinterpret_cast<const char*>(&v), 4);
        };
        return "glTF" + word(version) + word(28 + text.size() + bin.size()) + word(text.size()) +
               "JSON" + text + word(bin.size()) + std::string("BIN\0", 4) + bin;
    }
};

/// One triangle with everything a rule may be about: accessors 0 POSITION, 1 NORMAL, 2 TEXCOORD_0,
/// 3 indices, 4 JOINTS_0, 5 WEIGHTS_0, 6 inverse bind matrices, 7 times, 8 translations, 9 morph
/// target positions.
inline SmallGltf fullTriangle() {
    SmallGltf gltf;
    gltf.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    gltf.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, 5126, "VEC3", 3);
    gltf.add<float>({0, 0, 1, 0, 0, 1}, 5126, "VEC2", 2);
    gltf.add<uint16_t>({0, 1, 2}, 5123, "SCALAR", 1);
    gltf.add<uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, 5121, "VEC4", 4);
    gltf.add<float>({1, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, 5126, "VEC4", 4);
    gltf.add<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                     1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1},
                    5126, "MAT4", 16);
    gltf.add<float>({0, 1, 3}, 5126, "SCALAR", 1);
    gltf.add<float>({0, 0, 0, 2, 0, 0, 2, 4, 0}, 5126, "VEC3", 3);
    gltf.addPositions({0, 0, 1, 0, 0, 0, 0, 0, 0});
    gltf.json.update(Json::parse(R"({
        "materials":[{"name":"brick","pbrMetallicRoughness":{"roughnessFactor":0.5}}],
        "meshes":[{"name":"roof","weights":[0.5],"primitives":[{"material":0,"indices":3,
            "attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"JOINTS_0":4,"WEIGHTS_0":5},
            "targets":[{"POSITION":9}]}]}],
        "cameras":[{"type":"perspective","perspective":{"yfov":0.8,"znear":0.1,"zfar":100}}],
        "skins":[{"joints":[1,2],"inverseBindMatrices":6}],
        "animations":[{"channels":[{"sampler":0,"target":{"node":2,"path":"translation"}}],
            "samplers":[{"input":7,"output":8}]}],
        "nodes":[{"name":"house","mesh":0,"skin":0},{"children":[2]},
            {"translation":[0,1,0]},{"camera":0}],
        "scenes":[{"nodes":[0,1,3]}],"scene":0})"));
    return gltf;
}

}  // namespace rushlight::test

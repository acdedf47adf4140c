#include "sandbox/tool/frame_key.h"

#include "engine/core/hash128.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace rushlight::tool {
namespace {

namespace fs = std::filesystem;

std::string contentsOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string hashOf(std::string_view bytes) {
    return toText(hash128(std::as_bytes(std::span(bytes.data(), bytes.size()))));
}

/// glTF 2.0, section 4.4: a GLB's first chunk, after 12 bytes of header and 8 of its own, is the JSON.
std::string_view jsonOf(std::string_view file) {
    constexpr size_t kBefore = 20;
    if (!file.starts_with("glTF") || file.size() < kBefore) return file;
    uint32_t size;
    std::memcpy(&size, file.data() + 12, sizeof size);
    return file.substr(kBefore, size);
}

/// %20 and the like, as in URIs.
std::string decoded(const std::string& uri) {
    std::string text;
    for (size_t i = 0; i < uri.size(); ++i) {
        const bool escaped = uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(uint8_t(uri[i + 1])) &&
                             std::isxdigit(uint8_t(uri[i + 2]));
        text += escaped ? char(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
        i += escaped ? 2 : 0;
    }
    return text;
}

void collectUris(const nlohmann::json& json, std::vector<std::string>& uris) {
    if (json.is_object())
        for (const auto& [name, value] : json.items()) {
            if (name == "uri" && value.is_string() &&
                !value.get_ref<const std::string&>().starts_with("data:"))
                uris.push_back(decoded(value));
            else
                collectUris(value, uris);
        }
    else if (json.is_array())
        for (const auto& value : json) collectUris(value, uris);
}

/// Of the scene and all files that it names; what cannot be read was left out of the scene, too, or is its Error.
std::string sceneText(const std::string& scene) {
    const std::string file = contentsOf(scene);
    std::string text = hashOf(file);
    const auto json = nlohmann::json::parse(jsonOf(file), nullptr, false);
    std::vector<std::string> uris;
    collectUris(json, uris);
    std::ranges::sort(uris);
    for (const std::string& uri : uris)
        text += uri + hashOf(contentsOf(fs::path(scene).parent_path() / uri));
    return text;
}

}  // namespace

std::string frameKey(const CLI::App& command, const RenderOptions& options,
                     std::initializer_list<std::string_view> without) {
    std::string text = RUSHLIGHT_VERSION "\n" + sceneText(options.scene) + "\n";
    // Where they lie is no matter, what is in them is.
    constexpr std::string_view kFiles[] = {"SCENE", "--environment", "--probes"};
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 || std::ranges::find(without, name) != without.end()) continue;
        text += name;
        for (const std::string& value : option->results()) {
            const bool isFile =
                std::ranges::find(kFiles, name) != std::end(kFiles) && fs::exists(value);
            text += "=" + (isFile ? hashOf(contentsOf(value)) : value);
        }
        text += "\n";
    }
    if (options.probes != "off")
        text += hashOf(contentsOf(fs::path(options.scene).replace_extension(".probes")));
    return "rushlight frame " + hashOf(text);
}

}  // namespace rushlight::tool

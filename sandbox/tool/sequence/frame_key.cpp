#include "sandbox/tool/sequence/frame_key.h"

#include "engine/assets/gltf.h"
#include "engine/core/hash128.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

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

/// Of the scene and all files that it names; what cannot be read was left out of the scene, too, or
/// is its Error.
std::string sceneText(const std::string& scene) {
    std::string text = hashOf(contentsOf(scene));
    for (const fs::path& file : assets::namedFiles(scene))
        text += file.filename().string() + hashOf(contentsOf(file));
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
            const bool isFile = std::ranges::find(kFiles, name) != std::end(kFiles) &&
                                fs::exists(value);
            text += "=" + (isFile ? hashOf(contentsOf(value)) : value);
        }
        text += "\n";
    }
    if (options.probes != "off")
        text += hashOf(contentsOf(fs::path(options.scene).replace_extension(".probes")));
    return "rushlight frame " + hashOf(text);
}

}  // namespace rushlight::tool

#include "engine/assets/gltf.h"
#include "engine/assets/gltf/gltf_file.h"
#include "engine/assets/input_error.h"

#include <nlohmann/json.hpp>

#include <set>

namespace rushlight::assets {
namespace {

using Files = std::set<std::filesystem::path>;

void addFile(const std::string& uri, const std::filesystem::path& folder, Files& files) {
    if (isDataUri(uri)) return;
    try {
        files.insert(resolveUri(folder, decodePercent(uri)));
    } catch (const InputError&) {
        // Loading the file says why.
    }
}

void collect(const nlohmann::json& json, const std::filesystem::path& folder, Files& files) {
    if (!json.is_structured()) return;
    for (const auto& [name, value] : json.items())
        if (json.is_object() && name == "uri" && value.is_string())
            addFile(value, folder, files);
        else
            collect(value, folder, files);
}

}  // namespace

std::vector<std::filesystem::path> namedFiles(const std::filesystem::path& path) {
    Files files;
    try {
        const GltfContainer file = readContainer(path, LoadOptions().maxFileBytes);
        collect(nlohmann::json::parse(file.json, nullptr, false), path.parent_path(), files);
    } catch (const InputError&) {
    }
    return {files.begin(), files.end()};
}

}  // namespace rushlight::assets

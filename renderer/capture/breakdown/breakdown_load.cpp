#include "renderer/capture/breakdown/breakdown_json.h"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace rushlight {
namespace {

using nlohmann::ordered_json;

/// A file directly in the pictures' folder.
bool isPictureFile(const std::string& path) {
    const std::string folder = std::string(kPictureFolder) + "/";
    if (!path.starts_with(folder)) return false;
    const std::string name = path.substr(folder.size());
    return !name.empty() && name != "." && name != ".." && name.find('/') == name.npos &&
           name.find('\\') == name.npos && name.find('\0') == name.npos;
}

bool isText(const ordered_json& json, const char* key) {
    return json.contains(key) && json[key].is_string();
}
bool isNumber(const ordered_json& json, const char* key) {
    return json.contains(key) && json[key].is_number();
}

bool isPass(const ordered_json& pass) {
    if (!pass.is_object() || !isText(pass, "name") || !pass.contains("images") ||
        !pass["images"].is_array())
        return false;
    for (const ordered_json& image : pass["images"])
        if (!image.is_object() || !isText(image, "name") || !isText(image, "format") ||
            (image.contains("hash") && !isText(image, "hash")))
            return false;
    for (const char* key : {"draws", "triangles", "gl_calls", "state_changes", "cpu_ms", "gpu_ms"})
        if (!isNumber(pass, key)) return false;
    return true;
}

bool isPicture(const ordered_json& picture) {
    for (const char* key : {"name", "file", "section", "title", "note", "readout"})
        if (!picture.is_object() || !isText(picture, key)) return false;
    for (const char* key : {"pass", "image", "low", "high", "width", "height"})
        if (!isNumber(picture, key)) return false;
    return picture.contains("exact") && picture["exact"].is_boolean();
}

const char* whatIsWrong(const ordered_json& json) {
    if (!json.is_object() || !json.contains("breakdown") || !json["breakdown"].is_object())
        return "This is no frame.json of a breakdown.";
    const ordered_json& breakdown = json["breakdown"];
    if (!isText(breakdown, "title") || !json.contains("frame") || !json["frame"].is_object() ||
        !json.contains("passes") || !json["passes"].is_array() || !breakdown.contains("pictures") ||
        !breakdown["pictures"].is_array())
        return "It has no frame, passes or pictures; it is damaged or of another version.";
    for (const ordered_json& pass : json["passes"])
        if (!isPass(pass))
            return "One of its passes is not complete; it is damaged or of another version.";
    for (const ordered_json& picture : breakdown["pictures"]) {
        if (!isPicture(picture))
            return "One of its pictures is not complete; it is damaged or of another version.";
        if (!isPictureFile(picture["file"].get<std::string>()))
            return "It names a picture outside of its folder.";
    }
    return nullptr;
}

}  // namespace

Result<WrittenBreakdown> loadBreakdown(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) return fail(path, "The file cannot be read; name the frame.json of a breakdown.");
    const ordered_json json = ordered_json::parse(text.str(), nullptr, false);
    if (const char* wrong = whatIsWrong(json)) return fail(path, wrong);
    return WrittenBreakdown{std::filesystem::path(path).parent_path().string(), text.str()};
}

}  // namespace rushlight

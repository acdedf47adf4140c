#include "engine/assets/gltf/gltf_document.h"

#include "engine/assets/gltf/gltf_meshopt.h"
#include "engine/assets/gltf/gltf_schema.h"
#include "engine/assets/input_error.h"

#include <nlohmann/json.hpp>

#include <set>

namespace rushlight::assets {
namespace {

constexpr int kMaxJsonDepth = 64;

/// Parses without recursion on hostile nesting, and refuses keys that occur twice in an object.
Json parseJson(std::string_view text) {
    if (text.substr(0, 3) == "\xef\xbb\xbf") refuse("the JSON begins with a byte order mark.");
    std::vector<std::set<std::string>> keys;
    const auto check = [&](int depth, Json::parse_event_t event, Json& parsed) {
        if (depth > kMaxJsonDepth)
            refuse("the JSON is nested more than " + std::to_string(kMaxJsonDepth) +
                   " levels deep.");
        if (event == Json::parse_event_t::object_start) keys.emplace_back();
        if (event == Json::parse_event_t::object_end) keys.pop_back();
        if (event == Json::parse_event_t::key &&
            !keys.back().insert(parsed.get<std::string>()).second)
            refuse("the JSON has the key \"" + parsed.get<std::string>() +
                   "\" twice in one object.");
        return true;
    };
    try {
        return Json::parse(text.begin(), text.end(), check);
    } catch (const Json::exception& error) {
        refuse("the JSON cannot be parsed: " + std::string(error.what()));
    }
}

std::span<const uint8_t> keep(GltfDocument& document, Bytes bytes) {
    document.owned.push_back(std::move(bytes));
    return document.owned.back();
}

/// The bytes behind a URI: embedded, or a file in the folder of the glTF.
std::span<const uint8_t> fetch(GltfDocument& document, const std::string& uri,
                               std::string& mimeType, const LoadOptions& options) {
    if (isDataUri(uri)) return keep(document, decodeDataUri(uri, mimeType));
    const auto file = resolveUri(document.path.parent_path(), decodePercent(uri));
    return keep(document, readFile(file, options.maxFileBytes));
}

std::string text(const Json& object, const char* key) {
    const auto it = object.find(key);
    return it == object.end() ? std::string() : it->get<std::string>();
}

void readBuffers(GltfDocument& document, const Json& json, const LoadOptions& options) {
    if (!json.contains("buffers")) return;
    for (const Json& buffer : json["buffers"]) {
        const size_t index = document.buffers.size();
        const std::string what = numbered("buffer", index, text(buffer, "name"));
        const uint64_t length = buffer["byteLength"].get<uint64_t>();
        std::span<const uint8_t> bytes;
        if (buffer.contains("uri")) {
            std::string mimeType;
            bytes = fetch(document, buffer["uri"].get<std::string>(), mimeType, options);
            if (!mimeType.empty() && mimeType != "application/octet-stream" &&
                mimeType != "application/gltf-buffer")
                refuse(what + ": its data: URI has the media type '" + mimeType +
                       "', which is not one of a buffer.");
        } else if (index == 0 && document.container.hasBin) {
            bytes = document.container.bin;
        } else {
            document.buffers.emplace_back();  // a placeholder, which nothing may read
            continue;
        }
        if (bytes.size() < length)
            refuse(what + ": byteLength is " + std::to_string(length) + " but only " +
                   std::to_string(bytes.size()) + " bytes are there.");
        document.buffers.push_back(bytes.first(length));
    }
}

void readImages(GltfDocument& document, const Json& json, const LoadOptions& options) {
    if (!json.contains("images")) return;
    for (const Json& image : json["images"]) {
        ImageSource source;
        source.name = text(image, "name");
        const std::string uri = text(image, "uri");
        if (!uri.empty() && !isDataUri(uri)) source.name = uri;
        if (source.name.empty()) source.name = numbered("image", document.images.size());
        try {
            std::string mimeType;
            source.bytes = image.contains("bufferView")
                               ? document.viewBytes(image["bufferView"].get<int>())
                               : fetch(document, uri, mimeType, options);
        } catch (const InputError& error) {
            source.problem = error.message;
        }
        document.images.push_back(std::move(source));
    }
}

void readLightProfiles(GltfDocument& document, const Json& json, const LoadOptions& options) {
    if (!json.contains("extensions") || !json["extensions"].contains("EXT_lights_ies")) return;
    for (const Json& profile : json["extensions"]["EXT_lights_ies"]["lights"]) {
        ImageSource source;
        source.name = text(profile, "name");
        const std::string uri = text(profile, "uri");
        if (!uri.empty() && !isDataUri(uri)) source.name = uri;
        if (source.name.empty())
            source.name = numbered("light profile", document.lightProfiles.size());
        try {
            std::string mimeType;
            source.bytes = profile.contains("bufferView")
                               ? document.viewBytes(profile["bufferView"].get<int>())
                               : fetch(document, uri, mimeType, options);
        } catch (const InputError& error) {
            source.problem = error.message;
        }
        document.lightProfiles.push_back(std::move(source));
    }
}

/// tinygltf refuses indices whose accessor has no buffer view (all zeros, sparse, or compressed),
/// which the format allows: they borrow view 0 on the way through it. Returns the accessors to
/// mend.
std::vector<size_t> lendBufferViews(Json& json) {
    std::vector<size_t> borrowers;
    if (!json.contains("accessors")) return borrowers;
    Json& accessors = json["accessors"];
    for (size_t i = 0; i < accessors.size(); ++i) {
        if (accessors[i].contains("bufferView")) continue;
        borrowers.push_back(i);
        accessors[i]["bufferView"] = 0;
    }
    if (!borrowers.empty() && !json.contains("bufferViews"))
        json["bufferViews"] = Json::array({{{"buffer", 0}, {"byteLength", 1}}});
    return borrowers;
}

void buildStructs(GltfDocument& document, Json& json) {
    const std::vector<size_t> borrowers = lendBufferViews(json);
    json.erase("buffers");
    json.erase("images");
    json.erase("extras");
    const std::string reduced = json.dump();
    tinygltf::TinyGLTF parser;
    std::string problem, warning;
    if (!parser.LoadASCIIFromString(&document.gltf, &problem, &warning, reduced.c_str(),
                                    unsigned(reduced.size()), ""))
        refuse("it cannot be read: " + problem);
    for (size_t i : borrowers) document.gltf.accessors[i].bufferView = -1;
}

}  // namespace

std::span<const uint8_t> GltfDocument::viewBytes(int bufferView) const {
    if (bufferView < 0) return {};
    if (!decodedViews[size_t(bufferView)].empty()) return decodedViews[size_t(bufferView)];
    const tinygltf::BufferView& view = gltf.bufferViews[size_t(bufferView)];
    if (buffers[size_t(view.buffer)].empty())
        refuse(numbered("buffer", size_t(view.buffer)) +
               ": it has no URI and there is no BIN chunk for it, but buffer view " +
               std::to_string(bufferView) + " is read.");
    return buffers[size_t(view.buffer)].subspan(view.byteOffset, view.byteLength);
}

GltfDocument readDocument(const std::filesystem::path& path, const LoadOptions& options) {
    GltfDocument document;
    document.path = path;
    document.container = readContainer(path, options.maxFileBytes);
    Json json = parseJson(document.container.json);
    checkSchema(json);
    document.extensionsUsed = json.value("extensionsUsed", std::vector<std::string>());
    readBuffers(document, json, options);
    decodeMeshopt(document, json, options);
    const Json images = json.contains("images") ? Json{{"images", json["images"]}} : Json::object();
    buildStructs(document, json);
    readImages(document, images, options);
    readLightProfiles(document, json, options);
    return document;
}

}  // namespace rushlight::assets

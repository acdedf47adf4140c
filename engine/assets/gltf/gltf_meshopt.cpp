#include "engine/assets/gltf/gltf_meshopt.h"

#include "engine/assets/gltf/gltf_schema_parts.h"

#include <meshoptimizer.h>

namespace rushlight::assets {
namespace {

constexpr const char* kName = "EXT_meshopt_compression";

void checkStride(const JsonObject& extension, int64_t stride) {
    const std::string mode = extension.json()["mode"].get<std::string>();
    const std::string filter = extension.json().value("filter", "NONE");
    bool fits = mode == "ATTRIBUTES" ? stride % 4 == 0 : stride == 2 || stride == 4;
    if (filter == "OCTAHEDRAL") fits = fits && (stride == 4 || stride == 8);
    if (filter == "QUATERNION") fits = fits && stride == 8;
    if (filter != "NONE" && mode != "ATTRIBUTES")
        extension.wrong("its filter needs mode ATTRIBUTES.");
    if (!fits)
        extension.wrong("its byteStride " + std::to_string(stride) + " does not go with mode " +
                        mode + " and filter " + filter + ".");
}

int decode(const Json& extension, std::span<const uint8_t> source, Bytes& out) {
    const size_t count = extension["count"].get<size_t>();
    const size_t stride = extension["byteStride"].get<size_t>();
    const auto mode = extension["mode"].get<std::string>();
    const uint8_t* data = source.data();
    if (mode == "TRIANGLES")
        return meshopt_decodeIndexBuffer(out.data(), count, stride, data, source.size());
    if (mode == "INDICES")
        return meshopt_decodeIndexSequence(out.data(), count, stride, data, source.size());
    const int result = meshopt_decodeVertexBuffer(out.data(), count, stride, data, source.size());
    const auto filter = extension.value("filter", std::string("NONE"));
    if (result == 0 && filter == "OCTAHEDRAL") meshopt_decodeFilterOct(out.data(), count, stride);
    if (result == 0 && filter == "QUATERNION") meshopt_decodeFilterQuat(out.data(), count, stride);
    if (result == 0 && filter == "EXPONENTIAL") meshopt_decodeFilterExp(out.data(), count, stride);
    return result;
}

}  // namespace

void checkMeshoptView(const JsonObject& root, const JsonObject& view, size_t bufferCount) {
    const Json* json = findExtension(view, kName);
    if (!json) return;
    const JsonObject extension(*json, view.what() + " " + kName);
    const int64_t buffer = extension.index("buffer", bufferCount, Need::required);
    const int64_t offset = extension.integer("byteOffset", 0, INT64_C(1) << 40, Need::optional);
    const int64_t length = extension.integer("byteLength", 1, INT64_C(1) << 40, Need::required);
    const int64_t stride = extension.integer("byteStride", 2, 256, Need::required);
    const int64_t count = extension.integer("count", 1, UINT32_MAX, Need::required);
    extension.oneOf("mode", {"ATTRIBUTES", "TRIANGLES", "INDICES"}, Need::required);
    extension.oneOf("filter", {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"});
    checkStride(extension, stride);
    if (extension.json()["mode"] == "TRIANGLES" && count % 3 != 0)
        extension.wrong("its count " + std::to_string(count) + " is no multiple of three.");
    const int64_t available = root.json()["buffers"][size_t(buffer)]["byteLength"].get<int64_t>();
    if (offset + length > available)
        extension.wrong("it ends at byte " + std::to_string(offset + length) + " but buffer " +
                        std::to_string(buffer) + " has " + std::to_string(available) + ".");
    if (count * stride != view.json()["byteLength"].get<int64_t>())
        extension.wrong("it decodes to " + std::to_string(count * stride) +
                        " bytes but the view has " + view.json()["byteLength"].dump() + ".");
}

void decodeMeshopt(GltfDocument& document, const Json& gltf, const LoadOptions& options) {
    const Json views = gltf.value("bufferViews", Json::array());
    document.decodedViews.resize(views.size());
    uint64_t total = 0;
    for (size_t i = 0; i < views.size(); ++i) {
        if (!views[i].contains("extensions") || !views[i]["extensions"].contains(kName)) continue;
        const Json& extension = views[i]["extensions"][kName];
        const std::string what = nameOf("buffer view", i, views[i]) + " " + kName;
        const uint64_t size = views[i]["byteLength"].get<uint64_t>();
        total += size;
        if (total > options.maxFileBytes)
            refuse(what + ": with it the file decodes to " + std::to_string(total) +
                   " bytes; the limit is " + std::to_string(options.maxFileBytes) + ".");
        const auto source = document.buffers[extension["buffer"].get<size_t>()];
        if (source.empty()) refuse(what + ": its buffer has no data.");
        Bytes decoded(size);
        const auto encoded = source.subspan(extension.value("byteOffset", size_t(0)),
                                            extension["byteLength"].get<size_t>());
        if (decode(extension, encoded, decoded) != 0) refuse(what + ": its data are damaged.");
        document.owned.push_back(std::move(decoded));
        document.decodedViews[i] = document.owned.back();
    }
}

}  // namespace rushlight::assets

// Buffers, views, accessors, images, textures, samplers, meshes.
#include "engine/assets/gltf/gltf_meshopt.h"
#include "engine/assets/gltf/gltf_schema_parts.h"

#include <cfloat>
#include <vector>

namespace rushlight::assets {
namespace {

constexpr int64_t kMaxBytes = int64_t(1) << 40;

size_t componentsOf(const std::string& type) {
    if (type == "SCALAR") return 1;
    if (type == "MAT2") return 4;
    if (type == "MAT3") return 9;
    if (type == "MAT4") return 16;
    return size_t(type.back() - '0');
}

void checkSparse(const Counts& counts, const JsonObject& accessor) {
    const Json* json = accessor.object("sparse");
    if (!json) return;
    const JsonObject sparse(*json, accessor.what() + " sparse");
    sparse.integer("count", 1, INT32_MAX, Need::required);
    const JsonObject indices(*sparse.object("indices", Need::required), sparse.what() + " indices");
    indices.index("bufferView", counts.bufferViews, Need::required);
    indices.integer("byteOffset", 0, INT32_MAX, Need::optional);
    indices.oneOf("componentType", {5121, 5123, 5125}, Need::required);
    const JsonObject values(*sparse.object("values", Need::required), sparse.what() + " values");
    values.index("bufferView", counts.bufferViews, Need::required);
    values.integer("byteOffset", 0, INT32_MAX, Need::optional);
}

void checkView(const Counts& counts, const JsonObject& root, const JsonObject& view) {
    const int64_t buffer = view.index("buffer", counts.buffers, Need::required);
    const int64_t length = view.integer("byteLength", 1, kMaxBytes, Need::required);
    const int64_t offset = view.integer("byteOffset", 0, kMaxBytes, Need::optional);
    const int64_t stride = view.integer("byteStride", 4, 252, Need::optional, 4);
    if (stride % 4 != 0) view.wrong("its byteStride is no multiple of four.");
    view.oneOf("target", {34962, 34963});
    if (view.has("byteStride") && view.json().value("target", 0) == 34963)
        view.wrong("it has a byteStride but holds indices.");
    const int64_t available = root.json()["buffers"][size_t(buffer)]["byteLength"].get<int64_t>();
    if (offset + length > available)
        view.wrong("it ends at byte " + std::to_string(offset + length) + " but buffer " +
                   std::to_string(buffer) + " has " + std::to_string(available) + ".");
}

void checkPrimitive(const Counts& counts, const JsonObject& primitive) {
    const JsonObject attributes(*primitive.object("attributes", Need::required),
                                primitive.what() + " attributes");
    if (attributes.json().empty()) attributes.wrong("there are none.");
    for (const auto& [semantic, value] : attributes.json().items())
        attributes.index(semantic.c_str(), counts.accessors);
    primitive.index("indices", counts.accessors);
    primitive.index("material", counts.materials);
    primitive.integer("mode", 0, 6, Need::optional);
    if (findExtension(primitive, "KHR_draco_mesh_compression"))
        primitive.wrong("it uses KHR_draco_mesh_compression, which is not supported.");
    forEach(
        primitive, "targets", "target",
        [&](const JsonObject& target) {
            if (target.json().empty()) target.wrong("it has no attributes.");
            for (const auto& [semantic, value] : target.json().items()) {
                target.index(semantic.c_str(), counts.accessors);
                if (!primitive.json()["attributes"].contains(semantic))
                    target.wrong("it moves " + semantic + ", which the primitive does not have.");
            }
        },
        Need::optional, primitive.what() + " ");
}

void checkNumberedAttributes(const JsonObject& primitive) {
    std::vector<size_t> sets;
    for (const char* base : {"TEXCOORD_", "COLOR_", "JOINTS_", "WEIGHTS_"}) {
        size_t found = 0, consecutive = 0;
        const Json& attributes = primitive.json()["attributes"];
        for (const auto& [semantic, value] : attributes.items())
            found += semantic.rfind(base, 0) == 0;
        while (attributes.contains(base + std::to_string(consecutive))) ++consecutive;
        if (found != consecutive)
            primitive.wrong(std::string("its ") + base + " attributes are not numbered from 0 on.");
        sets.push_back(found);
    }
    if (sets[2] != sets[3])
        primitive.wrong("it has " + std::to_string(sets[2]) + " JOINTS attributes but " +
                        std::to_string(sets[3]) + " WEIGHTS.");
}

}  // namespace

const Json* findExtension(const JsonObject& owner, const char* name) {
    if (!owner.has("extensions")) return nullptr;
    const Json& extensions = owner.json()["extensions"];
    const auto it = extensions.find(name);
    return it == extensions.end() ? nullptr : &*it;
}

void checkBuffers(const Counts& counts, const JsonObject& root) {
    forEach(root, "buffers", "buffer", [&](const JsonObject& buffer) {
        buffer.text("uri");
        buffer.integer("byteLength", 1, kMaxBytes, Need::required);
    });
    forEach(root, "bufferViews", "buffer view", [&](const JsonObject& view) {
        checkView(counts, root, view);
        checkMeshoptView(root, view, counts.buffers);
    });
}

void checkAccessors(const Counts& counts, const JsonObject& root) {
    forEach(root, "accessors", "accessor", [&](const JsonObject& accessor) {
        const bool hasView = accessor.index("bufferView", counts.bufferViews) >= 0;
        accessor.integer("byteOffset", 0, kMaxBytes, Need::optional);
        if (accessor.has("byteOffset") && !hasView)
            accessor.wrong("it has a byteOffset but no bufferView.");
        accessor.oneOf("componentType", {5120, 5121, 5122, 5123, 5125, 5126}, Need::required);
        accessor.integer("count", 1, UINT32_MAX, Need::required);
        accessor.oneOf("type", {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"},
                       Need::required);
        accessor.boolean("normalized");
        const int type = accessor.json()["componentType"].get<int>();
        if (accessor.json().value("normalized", false) && (type == 5126 || type == 5125))
            accessor.wrong("it is normalised but its components are of 32 bits.");
        const size_t components = componentsOf(accessor.json()["type"].get<std::string>());
        accessor.numbers("min", components, -FLT_MAX, FLT_MAX);
        accessor.numbers("max", components, -FLT_MAX, FLT_MAX);
        checkSparse(counts, accessor);
    });
}

void checkTextures(const Counts& counts, const JsonObject& root) {
    forEach(root, "images", "image", [&](const JsonObject& image) {
        image.text("uri");
        image.text("mimeType");
        const bool hasView = image.index("bufferView", counts.bufferViews) >= 0;
        if (hasView == image.has("uri")) image.wrong("it must have either a uri or a bufferView.");
        if (hasView && !image.has("mimeType")) image.wrong("it has a bufferView but no mimeType.");
        image.oneOf("mimeType", {"image/png", "image/jpeg", "image/webp", "image/ktx2",
                                 "image/vnd-ms.dds", "image/avif"});
    });
    forEach(root, "samplers", "sampler", [&](const JsonObject& sampler) {
        sampler.oneOf("magFilter", {9728, 9729});
        sampler.oneOf("minFilter", {9728, 9729, 9984, 9985, 9986, 9987});
        sampler.oneOf("wrapS", {10497, 33071, 33648});
        sampler.oneOf("wrapT", {10497, 33071, 33648});
    });
    forEach(root, "textures", "texture", [&](const JsonObject& texture) {
        texture.index("source", counts.images);
        texture.index("sampler", counts.samplers);
        if (const Json* json = findExtension(texture, "EXT_texture_webp"))
            JsonObject(*json, texture.what() + " EXT_texture_webp").index("source", counts.images);
    });
}

void checkMeshes(const Counts& counts, const JsonObject& root) {
    forEach(root, "meshes", "mesh", [&](const JsonObject& mesh) {
        mesh.numbers("weights", 0, -FLT_MAX, FLT_MAX);
        forEach(
            mesh, "primitives", "primitive",
            [&](const JsonObject& primitive) {
                checkPrimitive(counts, primitive);
                checkNumberedAttributes(primitive);
            },
            Need::required, mesh.what() + " ");
    });
}

}  // namespace rushlight::assets

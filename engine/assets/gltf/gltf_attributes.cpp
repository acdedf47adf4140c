// Which types an attribute may have: glTF 2.0 section 3.7.2.1 and KHR_mesh_quantization.
#include "engine/assets/gltf/gltf_builder.h"
#include "engine/assets/input_error.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace rushlight::assets {
namespace {

enum Format : unsigned {
    f32 = 1,
    i8 = 2,
    i8n = 4,
    u8 = 8,
    u8n = 16,
    i16 = 32,
    i16n = 64,
    u16 = 128,
    u16n = 256,
};

struct Rule {
    std::string_view semantic;  ///< without the set number
    bool numbered;
    int low, high;  ///< components
    unsigned formats;
    unsigned quantized;  ///< more of them under KHR_mesh_quantization
};

constexpr unsigned kAnySmall = i8 | i8n | u8 | u8n | i16 | i16n | u16 | u16n;

constexpr std::array kRules = {
    Rule{"POSITION", false, 3, 3, f32, kAnySmall},
    Rule{"NORMAL", false, 3, 3, f32, i8n | i16n},
    Rule{"TANGENT", false, 4, 4, f32, i8n | i16n},
    Rule{"TEXCOORD", true, 2, 2, f32 | u8n | u16n, kAnySmall},
    Rule{"COLOR", true, 3, 4, f32 | u8n | u16n, 0},
    Rule{"JOINTS", true, 4, 4, u8 | u16, 0},
    Rule{"WEIGHTS", true, 4, 4, f32 | u8n | u16n, 0},
};

constexpr std::array kTargetRules = {
    Rule{"POSITION", false, 3, 3, f32, i8 | i8n | i16 | i16n},
    Rule{"NORMAL", false, 3, 3, f32, i8n | i16n},
    Rule{"TANGENT", false, 3, 3, f32, i8n | i16n},
    Rule{"TEXCOORD", true, 2, 2, f32 | i8n | i16n | u8n | u16n, kAnySmall},
    Rule{"COLOR", true, 3, 4, f32 | i8n | i16n | u8n | u16n, 0},
};

unsigned formatOf(const tinygltf::Accessor& accessor) {
    const bool n = accessor.normalized;
    switch (accessor.componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE: return n ? i8n : i8;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return n ? u8n : u8;
        case TINYGLTF_COMPONENT_TYPE_SHORT: return n ? i16n : i16;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return n ? u16n : u16;
        case TINYGLTF_COMPONENT_TYPE_FLOAT: return f32;
        default: return 0;
    }
}

template <size_t N>
const Rule* findRule(const std::array<Rule, N>& rules, std::string_view semantic) {
    const size_t underscore = semantic.find('_');
    for (const Rule& rule : rules)
        if (rule.semantic == semantic.substr(0, underscore) &&
            rule.numbered == (underscore != std::string_view::npos))
            return &rule;
    return nullptr;
}

bool isQuantizedFile(const GltfDocument& document) {
    const auto& used = document.extensionsUsed;
    return std::find(used.begin(), used.end(), "KHR_mesh_quantization") != used.end();
}

}  // namespace

void GltfBuilder::checkAttribute(const std::string& semantic, int accessor, size_t vertexCount,
                                 bool isTarget, const std::string& what) const {
    const tinygltf::Accessor& source = reader_.get(accessor);
    const std::string name = what + ": " + (isTarget ? "morph target " : "") + "attribute " +
                             semantic;
    if (source.count != vertexCount)
        refuse(name + " has " + std::to_string(source.count) + " elements but POSITION has " +
               std::to_string(vertexCount) + ".");
    if (source.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
        refuse(name + " has 32-bit integers, which only indices may have.");
    if (!semantic.empty() && semantic[0] == '_') return;  // an application's own
    const Rule* rule = isTarget ? findRule(kTargetRules, semantic) : findRule(kRules, semantic);
    if (!rule) refuse(name + " is none that glTF 2.0 knows.");
    const int components = componentCount(source);
    const unsigned allowed = rule->formats | (isQuantizedFile(document_) ? rule->quantized : 0);
    const bool isMatrix = source.type == TINYGLTF_TYPE_MAT2;
    if (components < rule->low || components > rule->high || isMatrix)
        refuse(name + " has " + std::to_string(components) + " components an element.");
    if (!(formatOf(source) & allowed))
        refuse(name + " has the component type " + std::to_string(source.componentType) +
               (source.normalized ? " (normalised)" : "") + ", which it may not have.");
    if (rule->semantic == "POSITION" && (source.minValues.empty() || source.maxValues.empty()))
        refuse(name + " declares no minimum and maximum.");
    if (source.bufferView < 0) return;
    const auto& view = gltf_.bufferViews[size_t(source.bufferView)];
    if (source.byteOffset % 4 != 0 || view.byteStride % 4 != 0)
        refuse(name + " does not begin or step at multiples of four bytes (offset " +
               std::to_string(source.byteOffset) + ", stride " + std::to_string(view.byteStride) +
               ").");
}

void GltfBuilder::checkIndices(const tinygltf::Primitive& source, const std::string& what) const {
    if (source.indices < 0) return;
    const tinygltf::Accessor& accessor = reader_.get(source.indices);
    const bool isUnsigned = accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                            accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                            accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    if (accessor.type != TINYGLTF_TYPE_SCALAR || !isUnsigned || accessor.normalized)
        refuse(what + ": its indices are not unsigned integers (component type " +
               std::to_string(accessor.componentType) + ").");
    if (accessor.bufferView >= 0 && gltf_.bufferViews[size_t(accessor.bufferView)].byteStride != 0)
        refuse(what + ": the buffer view of its indices has a byteStride.");
    const size_t vertexCount = reader_.count(source.attributes.at("POSITION"));
    const uint32_t restart = accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ? 0xff
                             : accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT
                                 ? 0xffff
                                 : 0xffffffff;
    const std::vector<uint32_t> indices = reader_.integers(source.indices);
    for (size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] == restart)
            refuse(what + ": index " + std::to_string(i) + " is " + std::to_string(restart) +
                   ", the primitive restart value, which glTF does not allow.");
        if (indices[i] >= vertexCount)
            refuse(what + ": index " + std::to_string(i) + " is " + std::to_string(indices[i]) +
                   " but there are only " + std::to_string(vertexCount) + " vertices.");
    }
}

/// What of the attributes is not drawn exactly.
void GltfBuilder::noteAttributes(const tinygltf::Primitive& source, const std::string& what) {
    if (source.material >= 0) {
        const Material& material = model_.materials[size_t(source.material)];
        for (const TextureUse* use :
             {&material.baseColorTexture, &material.metallicRoughnessTexture,
              &material.normalTexture, &material.occlusionTexture, &material.emissiveTexture,
              &material.transmissionTexture}) {
            const std::string semantic = "TEXCOORD_" + std::to_string(use->uvSet);
            if (use->image >= 0 && !source.attributes.count(semantic))
                unsupported(what + ": a texture on " + semantic + ", which it does not have");
        }
    }
    for (const auto& [semantic, accessor] : source.attributes) {
        const size_t underscore = semantic.find('_');
        if (underscore == 0 || underscore == std::string::npos) continue;
        const std::string base = semantic.substr(0, underscore);
        const std::string set = semantic.substr(underscore + 1);
        if (base == "TEXCOORD" ? set != "0" && set != "1" : base == "COLOR" && set != "0")
            unsupported(what + ": " + semantic);
        if ((base == "JOINTS" || base == "WEIGHTS") && set != "0")
            approximated(what + ": " + semantic + " (the first four weights are used)");
    }
}

}  // namespace rushlight::assets

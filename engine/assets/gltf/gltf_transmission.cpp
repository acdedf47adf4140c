// Light that goes through a surface: KHR_materials_transmission, and what of KHR_materials_volume a
// pane can show.
#include "engine/assets/gltf/gltf_builder.h"

#include <cmath>

namespace rushlight::assets {
namespace {

constexpr const char* kTransmission = "KHR_materials_transmission";
constexpr const char* kVolume = "KHR_materials_volume";

tinygltf::ExtensionMap extensionsOf(const tinygltf::Value& textureInfo) {
    tinygltf::ExtensionMap map;
    if (!textureInfo.Has("extensions")) return map;
    const tinygltf::Value& extensions = textureInfo.Get("extensions");
    for (const std::string& name : extensions.Keys()) map[name] = extensions.Get(name);
    return map;
}

float numberOf(const tinygltf::Value& value, const char* key, float fallback) {
    return value.Has(key) ? float(value.Get(key).GetNumberAsDouble()) : fallback;
}

}  // namespace

// Beer and Lambert: over the distance the colour is left of white, over n times that its nth power.
void GltfBuilder::buildVolume(const tinygltf::Value& value, Material& material) {
    const float thickness = numberOf(value, "thicknessFactor", 0);
    if (thickness <= 0 || material.transmission <= 0) return exact(kVolume);
    const bool textured = value.Has("thicknessTexture");
    approximated(
        std::string(kVolume) +
        ": a body colours light once, at its surface and by its thicknessFactor, not scaled "
        "by nodes" +
        (textured ? " (thicknessTexture is not read)" : "") + ", and does not refract it");
    if (!value.Has("attenuationColor") || !value.Has("attenuationDistance")) return;
    const float lengths = thickness / numberOf(value, "attenuationDistance", 1);
    const tinygltf::Value& color = value.Get("attenuationColor");
    for (int c = 0; c < 3; ++c) {
        const auto left = float(color.Get(size_t(c)).GetNumberAsDouble());
        material.transmissionColor[c] = std::pow(left, lengths);
    }
}

void GltfBuilder::buildTransmission(const tinygltf::Material& source, const std::string& what,
                                    Material& material) {
    const auto end = source.extensions.end();
    if (const auto found = source.extensions.find(kTransmission); found != end) {
        const tinygltf::Value& value = found->second;
        material.transmission = numberOf(value, "transmissionFactor", 0);
        if (material.transmission > 0)
            approximated(std::string(kTransmission) +
                         ": what is behind is seen straight and sharp, as through a pane without "
                         "thickness");
        else
            exact(kTransmission);
        if (value.Has("transmissionTexture")) {
            const tinygltf::Value& info = value.Get("transmissionTexture");
            const int texCoord = info.Has("texCoord") ? info.Get("texCoord").GetNumberAsInt() : 0;
            material.transmissionTexture = buildTexture(info.Get("index").GetNumberAsInt(),
                                                        texCoord, extensionsOf(info), false, what);
        }
    }
    if (const auto found = source.extensions.find(kVolume); found != end)
        buildVolume(found->second, material);
}

}  // namespace rushlight::assets

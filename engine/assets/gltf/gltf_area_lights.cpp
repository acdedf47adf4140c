// Area lights of nodes, by extras.rushlight.areaLight: glTF has none.
#include "engine/assets/gltf/gltf_builder.h"
#include "engine/assets/gltf/gltf_schema_parts.h"

#include <cfloat>

namespace rushlight::assets {
namespace {

AreaShape toShape(const std::string& name) {
    if (name == "disk") return AreaShape::disk;
    if (name == "sphere") return AreaShape::sphere;
    return name == "tube" ? AreaShape::tube : AreaShape::rectangle;
}

float numberOf(const tinygltf::Value& source, const char* key, float fallback) {
    return source.Has(key) ? float(source.Get(key).GetNumberAsDouble()) : fallback;
}

}  // namespace

void checkAreaLight(const JsonObject& node) {
    const std::optional<JsonObject> ours = extrasOf(node);
    const Json* json = ours ? ours->object("areaLight") : nullptr;
    if (!json) return;
    constexpr double kLeast = 1e-4, kMost = 1e6;  // metres
    const JsonObject light(*json, ours->what() + ".areaLight");
    light.oneOf("shape", {"rectangle", "disk", "sphere", "tube"}, Need::required);
    light.number("luminance", 0, FLT_MAX, Need::required);
    light.numbers("color", 3, 0, 1);
    light.boolean("twoSided");
    light.number("range", 0, FLT_MAX);
    const std::string shape = light.json()["shape"];
    if (shape == "rectangle" || shape == "disk") {
        light.array("size", Need::required);
        light.numbers("size", 2, kLeast, kMost);
        return;
    }
    light.number("radius", kLeast, kMost, Need::required);
    if (shape == "tube") light.number("length", kLeast, kMost, Need::required);
}

void GltfBuilder::buildAreaLight(size_t node, const tinygltf::Value& extras) {
    if (!extras.IsObject() || !extras.Has("rushlight")) return;
    const tinygltf::Value& ours = extras.Get("rushlight");
    if (!ours.Has("areaLight")) return;
    const tinygltf::Value& source = ours.Get("areaLight");
    AreaLight light;
    light.node = int(node);
    light.shape = toShape(source.Get("shape").Get<std::string>());
    if (source.Has("size"))
        for (int i = 0; i < 2; ++i)
            light.size[i] = float(source.Get("size").Get(size_t(i)).GetNumberAsDouble());
    if (source.Has("color"))
        for (int i = 0; i < 3; ++i)
            light.color[i] = float(source.Get("color").Get(size_t(i)).GetNumberAsDouble());
    light.radius = numberOf(source, "radius", 0);
    light.length = numberOf(source, "length", 0);
    light.luminance = numberOf(source, "luminance", 0);
    light.range = numberOf(source, "range", 0);
    light.twoSided = source.Has("twoSided") && source.Get("twoSided").Get<bool>();
    model_.areaLights.push_back(light);
    exact("area lights of extras.rushlight");
}

}  // namespace rushlight::assets

// Materials, cameras, lights.
#include "engine/assets/gltf/gltf_schema_parts.h"

#include <cfloat>

namespace rushlight::assets {
namespace {

constexpr double kHalfPi = 1.57079632679489662;
constexpr double kJustAboveZero = FLT_MIN;

void checkTextureInfo(const Counts& counts, const JsonObject& owner, const char* key) {
    const Json* json = owner.object(key);
    if (!json) return;
    const JsonObject info(*json, owner.what() + " " + key);
    info.index("index", counts.textures, Need::required);
    info.integer("texCoord", 0, 64, Need::optional);
    info.number("scale", -FLT_MAX, FLT_MAX);
    info.number("strength", 0, 1);
    if (const Json* extension = findExtension(info, "KHR_texture_transform")) {
        const JsonObject transform(*extension, info.what() + " KHR_texture_transform");
        transform.numbers("offset", 2, -FLT_MAX, FLT_MAX);
        transform.numbers("scale", 2, -FLT_MAX, FLT_MAX);
        transform.number("rotation", -FLT_MAX, FLT_MAX);
        transform.integer("texCoord", 0, 64, Need::optional);
    }
}

void checkTransmission(const Counts& counts, const JsonObject& material) {
    if (const Json* json = findExtension(material, "KHR_materials_transmission")) {
        const JsonObject extension(*json, material.what() + " KHR_materials_transmission");
        extension.number("transmissionFactor", 0, 1);
        checkTextureInfo(counts, extension, "transmissionTexture");
    }
    if (const Json* json = findExtension(material, "KHR_materials_volume")) {
        const JsonObject extension(*json, material.what() + " KHR_materials_volume");
        extension.number("thicknessFactor", 0, FLT_MAX);
        checkTextureInfo(counts, extension, "thicknessTexture");
        extension.number("attenuationDistance", kJustAboveZero, FLT_MAX);
        extension.numbers("attenuationColor", 3, 0, 1);
    }
}

void checkMaterial(const Counts& counts, const JsonObject& material) {
    if (const Json* json = material.object("pbrMetallicRoughness")) {
        const JsonObject pbr(*json, material.what() + " pbrMetallicRoughness");
        pbr.numbers("baseColorFactor", 4, 0, 1);
        pbr.number("metallicFactor", 0, 1);
        pbr.number("roughnessFactor", 0, 1);
        checkTextureInfo(counts, pbr, "baseColorTexture");
        checkTextureInfo(counts, pbr, "metallicRoughnessTexture");
    }
    checkTextureInfo(counts, material, "normalTexture");
    checkTextureInfo(counts, material, "occlusionTexture");
    checkTextureInfo(counts, material, "emissiveTexture");
    material.numbers("emissiveFactor", 3, 0, 1);
    material.oneOf("alphaMode", {"OPAQUE", "MASK", "BLEND"});
    material.number("alphaCutoff", 0, FLT_MAX);
    material.boolean("doubleSided");
    checkTransmission(counts, material);
    if (const Json* json = findExtension(material, "KHR_materials_emissive_strength"))
        JsonObject(*json, material.what() + " KHR_materials_emissive_strength")
            .number("emissiveStrength", 0, FLT_MAX);
}

void checkPerspective(const JsonObject& camera) {
    const JsonObject view(*camera.object("perspective", Need::required),
                          camera.what() + " perspective");
    view.number("aspectRatio", kJustAboveZero, FLT_MAX);
    const double fov = view.number("yfov", kJustAboveZero, FLT_MAX, Need::required);
    if (fov >= 2 * kHalfPi) view.wrong("its yfov is " + std::to_string(fov) + ", not below pi.");
    const double near = view.number("znear", kJustAboveZero, FLT_MAX, Need::required);
    const double far = view.number("zfar", kJustAboveZero, FLT_MAX, Need::optional, FLT_MAX);
    if (far <= near) view.wrong("its zfar is not beyond its znear.");
}

void checkOrthographic(const JsonObject& camera) {
    const JsonObject view(*camera.object("orthographic", Need::required),
                          camera.what() + " orthographic");
    for (const char* key : {"xmag", "ymag"})
        if (view.number(key, -FLT_MAX, FLT_MAX, Need::required) == 0)
            view.wrong(std::string("its ") + key + " is zero.");
    const double near = view.number("znear", 0, FLT_MAX, Need::required);
    const double far = view.number("zfar", kJustAboveZero, FLT_MAX, Need::required);
    if (far <= near) view.wrong("its zfar is not beyond its znear.");
}

void checkSpot(const JsonObject& light) {
    const JsonObject spot(*light.object("spot", Need::required), light.what() + " spot");
    const double inner = spot.number("innerConeAngle", 0, kHalfPi);
    const double outer = spot.number("outerConeAngle", kJustAboveZero, kHalfPi + 1e-6,
                                     Need::optional, kHalfPi / 2);
    if (inner >= outer) spot.wrong("its innerConeAngle is not below its outerConeAngle.");
}

}  // namespace

void checkMaterials(const Counts& counts, const JsonObject& root) {
    forEach(root, "materials", "material",
            [&](const JsonObject& material) { checkMaterial(counts, material); });
}

void checkCameras(const JsonObject& root) {
    forEach(root, "cameras", "camera", [&](const JsonObject& camera) {
        camera.oneOf("type", {"perspective", "orthographic"}, Need::required);
        if (camera.has("perspective") && camera.has("orthographic"))
            camera.wrong("it has both a perspective and an orthographic view.");
        if (camera.json()["type"] == "perspective")
            checkPerspective(camera);
        else
            checkOrthographic(camera);
    });
}

size_t checkLights(const Counts& counts, const JsonObject& root) {
    const Json* json = findExtension(root, "KHR_lights_punctual");
    if (!json) return 0;
    const JsonObject extension(*json, "KHR_lights_punctual");
    forEach(
        extension, "lights", "light",
        [&](const JsonObject& light) {
            light.oneOf("type", {"directional", "point", "spot"}, Need::required);
            light.numbers("color", 3, 0, FLT_MAX);
            light.number("intensity", 0, FLT_MAX);
            light.number("range", kJustAboveZero, FLT_MAX);
            if (light.json()["type"] == "spot") checkSpot(light);
            checkLightExtras(counts, light);
        },
        Need::required);
    return extension.json()["lights"].size();
}

}  // namespace rushlight::assets

// Light that comes from around: EXT_lights_image_based, and reflection probes in nodes' extras.
#include "engine/assets/gltf/gltf_schema_parts.h"

#include <cfloat>
#include <cmath>

namespace rushlight::assets {
namespace {

constexpr const char* kImageBased = "EXT_lights_image_based";
constexpr int64_t kMaxSize = 2048;  ///< 300 MB as floats

void checkRotation(const JsonObject& light) {
    light.numbers("rotation", 4, -1, 1);
    if (!light.has("rotation")) return;
    double squares = 0;
    for (const Json& part : light.json()["rotation"]) squares += std::pow(part.get<double>(), 2);
    if (std::abs(std::sqrt(squares) - 1) > 0.01)
        light.wrong("its rotation is a quaternion of length " + std::to_string(std::sqrt(squares)) +
                    " instead of 1.");
}

/// Element `i` of an array of arrays as the property of an object, so that the same rules check it.
Json elementOf(const Json& array, size_t i, const char* key) { return Json{{key, array[i]}}; }

void checkCoefficients(const JsonObject& light) {
    const Json& rows = *light.array("irradianceCoefficients", Need::required);
    if (rows.size() != 9)
        light.wrong("its irradianceCoefficients has " + std::to_string(rows.size()) +
                    " elements instead of 9.");
    for (size_t i = 0; i < rows.size(); ++i) {
        const Json row = elementOf(rows, i, "coefficients");
        const JsonObject object(row, light.what() + " irradianceCoefficients " + std::to_string(i));
        object.array("coefficients", Need::required);
        object.numbers("coefficients", 3, -FLT_MAX, FLT_MAX);
    }
}

void checkImages(const Counts& counts, const JsonObject& light) {
    const int64_t size = light.integer("specularImageSize", 1, kMaxSize, Need::required);
    if ((size & (size - 1)) != 0)
        light.wrong("its specularImageSize is " + std::to_string(size) +
                    ", which is no power of two.");
    const Json& levels = *light.array("specularImages", Need::required);
    if (levels.size() > 16 || size >> (levels.size() - 1) == 0)
        light.wrong("it has " + std::to_string(levels.size()) +
                    " levels of specularImages, more than images of " + std::to_string(size) +
                    " pixels can have.");
    for (size_t i = 0; i < levels.size(); ++i) {
        const std::string what = light.what() + " specularImages " + std::to_string(i);
        const Json level = elementOf(levels, i, "faces");
        const Json& faces = *JsonObject(level, what).array("faces", Need::required);
        if (faces.size() != 6)
            light.wrong("its specularImages " + std::to_string(i) + " has " +
                        std::to_string(faces.size()) + " faces instead of 6.");
        for (size_t face = 0; face < 6; ++face) {
            const Json image = elementOf(faces, face, "image");
            JsonObject(image, what).index("image", counts.images, Need::required);
        }
    }
}

}  // namespace

size_t checkImageBasedLights(const Counts& counts, const JsonObject& root) {
    const Json* json = findExtension(root, kImageBased);
    if (!json) return 0;
    const JsonObject extension(*json, kImageBased);
    forEach(
        extension, "lights", "image-based light",
        [&](const JsonObject& light) {
            light.text("name");
            light.number("intensity", 0, FLT_MAX);
            checkRotation(light);
            checkCoefficients(light);
            checkImages(counts, light);
        },
        Need::required);
    return extension.json()["lights"].size();
}

void checkImageBasedLightOf(const JsonObject& scene, size_t lights) {
    if (const Json* json = findExtension(scene, kImageBased))
        JsonObject(*json, scene.what() + " " + kImageBased).index("light", lights, Need::required);
}

void checkReflectionProbe(const JsonObject& node) {
    const std::optional<JsonObject> ours = extrasOf(node);
    const Json* json = ours ? ours->object("reflectionProbe") : nullptr;
    if (!json) return;
    const JsonObject probe(*json, ours->what() + ".reflectionProbe");
    probe.array("size", Need::required);
    probe.numbers("size", 3, 1e-3, 1e6);
    probe.numbers("offset", 3, -1e6, 1e6);
    if (probe.has("blend") && probe.json()["blend"].is_number())
        probe.number("blend", 0, 1e6);
    else
        probe.numbers("blend", 3, 0, 1e6);
    probe.number("intensity", 0, FLT_MAX);
    const int64_t resolution = probe.integer("resolution", 16, 1024, Need::optional, 256);
    if ((resolution & (resolution - 1)) != 0)
        probe.wrong("its resolution is " + std::to_string(resolution) +
                    ", which is no power of two.");
    const Json size = probe.json()["size"];
    if (!probe.has("offset")) return;
    for (size_t axis = 0; axis < 3; ++axis)
        if (std::abs(probe.json()["offset"][axis].get<double>()) > size[axis].get<double>() / 2)
            probe.wrong("its offset moves the box off the node, from which it is captured.");
}

}  // namespace rushlight::assets

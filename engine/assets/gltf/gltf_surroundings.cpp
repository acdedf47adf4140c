// Light that comes from around: EXT_lights_image_based, and reflection probes in nodes' extras.
#include "engine/assets/gltf/gltf_builder.h"
#include "engine/assets/image.h"
#include "engine/assets/input_error.h"

#include <array>
#include <cmath>

namespace rushlight::assets {
namespace {

constexpr const char* kImageBased = "EXT_lights_image_based";

vec3 toVec3(const tinygltf::Value& value) {
    vec3 v;
    for (int i = 0; i < 3; ++i) v[i] = float(value.Get(size_t(i)).GetNumberAsDouble());
    return v;
}

float toFloat(const tinygltf::Value& value, const char* key, float fallback) {
    return value.Has(key) ? float(value.Get(key).GetNumberAsDouble()) : fallback;
}

std::array<float, 256> makeLinear() {
    std::array<float, 256> linear;
    for (size_t i = 0; i < linear.size(); ++i) {
        const float c = float(i) / 255;
        linear[i] = c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
    }
    return linear;
}

/// A PNG whose texels have an alpha of their own: colour type 4 or 6 of its header.
bool isRgbd(std::span<const uint8_t> bytes) {
    return bytes.size() > 25 && bytes[0] == 0x89 && bytes[1] == 'P' && (bytes[25] & 4) != 0;
}

/// Images are as the surroundings look from within; the columns of GL's faces run the other way.
/// RGBD: radiance is colour over alpha, and the colour is sRGB encoded, as is that of all of glTF's
/// images.
void storeFace(const Image& image, bool rgbd, std::vector<vec3>& out) {
    static const std::array<float, 256> linear = makeLinear();
    const size_t size = image.width;
    for (size_t y = 0; y < size; ++y)
        for (size_t x = 0; x < size; ++x) {
            const uint8_t* p = &image.pixels[(y * size + (size - 1 - x)) * 4];
            const float divisor = rgbd ? float(std::max<int>(p[3], 1)) / 255 : 1;
            out.push_back(vec3(linear[p[0]], linear[p[1]], linear[p[2]]) / divisor);
        }
}

}  // namespace

void GltfBuilder::buildReflectionProbe(size_t index, const tinygltf::Value& extras) {
    if (!extras.IsObject() || !extras.Has("rushlight")) return;
    const tinygltf::Value& ours = extras.Get("rushlight");
    if (!ours.Has("reflectionProbe")) return;
    const tinygltf::Value& source = ours.Get("reflectionProbe");
    ReflectionProbe probe;
    probe.node = int(index);
    probe.size = toVec3(source.Get("size"));
    if (source.Has("offset")) probe.offset = toVec3(source.Get("offset"));
    if (source.Has("blend")) {
        const tinygltf::Value& blend = source.Get("blend");
        const float sides = blend.IsNumber() ? float(blend.GetNumberAsDouble()) : 0;
        probe.blend = blend.IsNumber() ? vec3(sides, 0, sides) : toVec3(blend);
    }
    probe.intensity = toFloat(source, "intensity", 1);
    probe.resolution = uint32_t(toFloat(source, "resolution", 256));
    model_.reflectionProbes.push_back(probe);
    exact("reflection probes of extras.rushlight");
}

void GltfBuilder::buildImageBasedLight() {
    const int scene = gltf_.defaultScene >= 0 ? gltf_.defaultScene : gltf_.scenes.empty() ? -1 : 0;
    if (scene < 0) return;
    const auto& extensions = gltf_.scenes[size_t(scene)].extensions;
    const auto used = extensions.find(kImageBased);
    const auto lights = gltf_.extensions.find(kImageBased);
    if (used == extensions.end() || lights == gltf_.extensions.end()) return;
    const size_t index = size_t(used->second.Get("light").GetNumberAsInt());
    const tinygltf::Value& source = lights->second.Get("lights").Get(index);
    ImageBasedLight light;
    if (source.Has("name")) light.name = source.Get("name").Get<std::string>();
    light.intensity = toFloat(source, "intensity", 1);
    if (source.Has("rotation")) {
        const tinygltf::Value& r = source.Get("rotation");
        const auto part = [&](size_t i) { return float(r.Get(i).GetNumberAsDouble()); };
        light.rotation = glm::normalize(quat(part(3), part(0), part(1), part(2)));
    }
    for (size_t i = 0; i < 9; ++i)
        light.irradiance[i] = toVec3(source.Get("irradianceCoefficients").Get(i));
    light.size = uint32_t(source.Get("specularImageSize").GetNumberAsInt());
    light.levels = uint32_t(source.Get("specularImages").ArrayLen());
    const std::string what = numbered("image-based light", index, light.name);
    try {
        for (uint32_t level = 0; level < light.levels; ++level)
            for (size_t face = 0; face < 6; ++face)
                readFace(light, level,
                         source.Get("specularImages").Get(int(level)).Get(face).GetNumberAsInt());
    } catch (const InputError& error) {
        const std::string message = what + ": " + error.message;
        if (options_.strict || options_.missingImages == MissingImages::refuse) refuse(message);
        model_.warnings.push_back(message + " The light is left out.");
        unsupported(std::string(kImageBased) + ": a light whose images cannot be read (left out)");
        return;
    }
    model_.imageBasedLight = std::move(light);
    approximated(std::string(kImageBased) +
                 ": its levels of roughness are resampled to those of the renderer");
}

void GltfBuilder::readFace(ImageBasedLight& light, uint32_t level, int index) {
    const ImageSource& source = document_.images[size_t(index)];
    const std::string name = "image '" + source.name + "': ";
    if (!source.problem.empty()) refuse(name + source.problem);
    const uint32_t wanted = light.size >> level;
    const Result<uvec2> size = readImageSize(source.name, source.bytes);
    if (!size) refuse(name + size.error().message);
    if (size->x != wanted || size->y != wanted)
        refuse(name + "it has " + std::to_string(size->x) + " x " + std::to_string(size->y) +
               " pixels where level " + std::to_string(level) + " of the light needs " +
               std::to_string(wanted) + " x " + std::to_string(wanted) + ".");
    const Result<Image> image = decodeImage(source.name, source.bytes,
                                            {wanted, uint64_t(wanted) * wanted});
    if (!image) refuse(name + image.error().message);
    storeFace(*image, isRgbd(source.bytes), light.texels);
}

}  // namespace rushlight::assets

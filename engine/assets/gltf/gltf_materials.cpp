#include "engine/assets/gltf/gltf_builder.h"
#include "engine/assets/image.h"
#include "engine/assets/input_error.h"

#include <algorithm>

namespace rushlight::assets {
namespace {

vec2 toVec2(const tinygltf::Value& value, const char* key, const vec2& fallback) {
    if (!value.Has(key)) return fallback;
    const tinygltf::Value& array = value.Get(key);
    return {float(array.Get(0).GetNumberAsDouble()), float(array.Get(1).GetNumberAsDouble())};
}

float toFloat(const tinygltf::Value& value, const char* key, float fallback) {
    return value.Has(key) ? float(value.Get(key).GetNumberAsDouble()) : fallback;
}

Wrap toWrap(int wrap) {
    if (wrap == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clampToEdge;
    return wrap == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirroredRepeat : Wrap::repeat;
}

Sampler toSampler(const tinygltf::Sampler& source) {
    Sampler sampler;
    sampler.wrapU = toWrap(source.wrapS);
    sampler.wrapV = toWrap(source.wrapT);
    const auto pick = [](bool nearest) { return nearest ? Filter::nearest : Filter::linear; };
    sampler.magnify = pick(source.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST);
    const int minify = source.minFilter;
    sampler.useMipmaps = minify != TINYGLTF_TEXTURE_FILTER_NEAREST &&
                         minify != TINYGLTF_TEXTURE_FILTER_LINEAR;
    sampler.minify = pick(minify == TINYGLTF_TEXTURE_FILTER_NEAREST ||
                          minify == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST ||
                          minify == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR);
    sampler.mipmap = pick(minify == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST ||
                          minify == TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST);
    return sampler;
}

AlphaMode toAlphaMode(const std::string& mode) {
    if (mode == "MASK") return AlphaMode::mask;
    return mode == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
}

}  // namespace

/// An image used both as colour and as data becomes two, because one texture has one encoding.
int GltfBuilder::imageFor(int texture, bool isColor) {
    const tinygltf::Texture& source = gltf_.textures[size_t(texture)];
    int image = source.source;
    const auto webp = source.extensions.find("EXT_texture_webp");
    if (webp != source.extensions.end() && webp->second.Has("source")) {
        image = webp->second.Get("source").GetNumberAsInt();
        exact("EXT_texture_webp");
    }
    if (image < 0) return -1;
    const auto [it, isNew] = imageOf_.try_emplace({image, isColor}, int(model_.images.size()));
    if (isNew) {
        Image entry;
        entry.name = document_.images[size_t(image)].name;
        entry.isColor = isColor;
        model_.images.push_back(std::move(entry));
        imageSources_.push_back(image);
    }
    return it->second;
}

TextureUse GltfBuilder::buildTexture(int texture, int texCoord,
                                     const tinygltf::ExtensionMap& extensions, bool isColor,
                                     const std::string& what) {
    TextureUse use;
    if (texture < 0) return use;
    use.image = imageFor(texture, isColor);
    if (use.image < 0) {
        unsupported(what + ": the texture's image format");
        return use;
    }
    const int sampler = gltf_.textures[size_t(texture)].sampler;
    if (sampler >= 0) use.sampler = toSampler(gltf_.samplers[size_t(sampler)]);
    const auto transform = extensions.find("KHR_texture_transform");
    if (transform != extensions.end()) {
        const tinygltf::Value& value = transform->second;
        use.offset = toVec2(value, "offset", vec2(0));
        use.scale = toVec2(value, "scale", vec2(1));
        use.rotation = toFloat(value, "rotation", 0);
        if (value.Has("texCoord")) texCoord = value.Get("texCoord").GetNumberAsInt();
        exact("KHR_texture_transform");
    }
    if (texCoord > 1) {
        unsupported(what + ": TEXCOORD_" + std::to_string(texCoord) + " (texture left out)");
        return TextureUse();
    }
    use.uvSet = uint8_t(texCoord);
    return use;
}

void GltfBuilder::noteMaterialExtensions(const tinygltf::Material& source,
                                         const std::string& what) {
    for (const auto& [name, value] : source.extensions) {
        if (name == "KHR_materials_emissive_strength" || name == "KHR_materials_unlit")
            exact(name);
        else if (name != "KHR_materials_transmission" && name != "KHR_materials_volume")
            unsupported(what + ": " + name);
    }
}

Material GltfBuilder::buildMaterial(const tinygltf::Material& source, const std::string& what) {
    Material material;
    material.name = source.name;
    const auto& pbr = source.pbrMetallicRoughness;
    for (int c = 0; c < 4; ++c) material.baseColor[c] = float(pbr.baseColorFactor[size_t(c)]);
    for (int c = 0; c < 3; ++c) material.emissive[c] = float(source.emissiveFactor[size_t(c)]);
    material.metallic = float(pbr.metallicFactor);
    material.roughness = float(pbr.roughnessFactor);
    material.normalScale = float(source.normalTexture.scale);
    material.occlusionStrength = float(source.occlusionTexture.strength);
    const auto texture = [&](const auto& info, bool isColor) {
        return buildTexture(info.index, info.texCoord, info.extensions, isColor, what);
    };
    material.baseColorTexture = texture(pbr.baseColorTexture, true);
    material.metallicRoughnessTexture = texture(pbr.metallicRoughnessTexture, false);
    material.normalTexture = texture(source.normalTexture, false);
    material.occlusionTexture = texture(source.occlusionTexture, false);
    material.emissiveTexture = texture(source.emissiveTexture, true);
    if (material.normalTexture.image >= 0)
        model_.images[size_t(material.normalTexture.image)].isNormal = true;
    material.alphaMode = toAlphaMode(source.alphaMode);
    material.alphaCutoff = float(source.alphaCutoff);
    material.doubleSided = source.doubleSided;
    material.unlit = source.extensions.count("KHR_materials_unlit") != 0;
    const auto strength = source.extensions.find("KHR_materials_emissive_strength");
    if (strength != source.extensions.end())
        material.emissive *= toFloat(strength->second, "emissiveStrength", 1);
    buildTransmission(source, what, material);
    noteMaterialExtensions(source, what);
    return material;
}

void GltfBuilder::buildMaterials() {
    for (const tinygltf::Material& source : gltf_.materials) {
        const std::string what = numbered("material", model_.materials.size(), source.name);
        model_.materials.push_back(buildMaterial(source, what));
    }
}

void GltfBuilder::decodeImages() {
    const uint32_t count = uint32_t(model_.images.size());
    std::vector<std::string> problems(count);
    std::vector<uint64_t> sizes(count);
    SerialJobs serial;
    JobSystem& jobs = options_.jobs ? *options_.jobs : serial;
    const auto source = [&](uint32_t i) -> const ImageSource& {
        return document_.images[size_t(imageSources_[i])];
    };
    jobs.forRanges(count, 4, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) {
            problems[i] = source(i).problem;
            if (!problems[i].empty()) continue;
            const Result<uvec2> size = readImageSize(source(i).name, source(i).bytes);
            if (size) sizes[i] = uint64_t(size->x) * size->y;
            if (!size) problems[i] = size.error().message;
        }
    });
    for (size_t i = 0; i < document_.images.size(); ++i) {
        const ImageSource& unused = document_.images[i];
        const bool isUsed = imageOf_.count({int(i), true}) || imageOf_.count({int(i), false});
        if (isUsed || unused.problem.empty()) continue;
        const std::string message = "image '" + unused.name + "': " + unused.problem;
        if (options_.strict || options_.missingImages == MissingImages::refuse) refuse(message);
        model_.warnings.push_back(message + " Nothing uses it.");
    }
    uint64_t total = 0;
    for (const uint64_t size : sizes) total += size;
    if (total > options_.maxImagePixels)
        refuse("its images have " + std::to_string(total) + " pixels together; the limit is " +
               std::to_string(options_.maxImagePixels) + ".");
    const ImageLimits limits{options_.maxImageSide, options_.maxImagePixels};
    jobs.forRanges(count, 1, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) {
            if (!problems[i].empty()) continue;
            Result<Image> image = decodeImage(source(i).name, source(i).bytes, limits);
            if (!image) {
                problems[i] = image.error().message;
                continue;
            }
            image->isColor = model_.images[i].isColor;
            image->isNormal = model_.images[i].isNormal;
            model_.images[i] = std::move(*image);
        }
    });
    for (uint32_t i = 0; i < count; ++i) {
        if (problems[i].empty()) continue;
        const std::string message = "image '" + source(i).name + "': " + problems[i];
        if (options_.strict || options_.missingImages == MissingImages::refuse) refuse(message);
        Image checker = makeMissingImage(source(i).name);
        checker.isColor = model_.images[i].isColor;
        checker.isNormal = model_.images[i].isNormal;
        model_.images[i] = std::move(checker);
        model_.warnings.push_back(message + " A checker stands for it.");
    }
}

}  // namespace rushlight::assets

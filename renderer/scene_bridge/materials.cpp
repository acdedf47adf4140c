#include "renderer/scene_bridge/materials.h"

namespace rushlight {
namespace {

TextureWrap wrapOf(assets::Wrap wrap) {
    switch (wrap) {
        case assets::Wrap::repeat: return TextureWrap::repeat;
        case assets::Wrap::clampToEdge: return TextureWrap::clampToEdge;
        case assets::Wrap::mirroredRepeat: return TextureWrap::mirroredRepeat;
    }
    return TextureWrap::repeat;
}

TextureFilter filterOf(assets::Filter filter) {
    return filter == assets::Filter::nearest ? TextureFilter::nearest : TextureFilter::linear;
}

SamplerDesc samplerOf(const assets::Sampler& from) {
    SamplerDesc sampler;
    sampler.wrapU = wrapOf(from.wrapU);
    sampler.wrapV = wrapOf(from.wrapV);
    sampler.magnify = filterOf(from.magnify);
    sampler.minify = filterOf(from.minify);
    sampler.mipmap = filterOf(from.mipmap);
    sampler.useMipmaps = from.useMipmaps;
    return sampler;
}

AlphaMode alphaModeOf(assets::AlphaMode mode) {
    switch (mode) {
        case assets::AlphaMode::opaque: return AlphaMode::opaque;
        case assets::AlphaMode::mask: return AlphaMode::mask;
        case assets::AlphaMode::blend: return AlphaMode::blend;
    }
    return AlphaMode::opaque;
}

/// All but the textures.
MaterialDesc factorsOf(const assets::Material& from) {
    MaterialDesc desc;
    desc.label = from.name;
    desc.baseColor = from.baseColor;
    desc.metallic = from.metallic;
    desc.roughness = from.roughness;
    desc.normalScale = from.normalScale;
    desc.occlusionStrength = from.occlusionStrength;
    desc.emissive = from.emissive;
    desc.alphaMode = alphaModeOf(from.alphaMode);
    desc.alphaCutoff = from.alphaCutoff;
    desc.transmission = from.transmission;
    desc.transmissionColor = from.transmissionColor;
    desc.doubleSided = from.doubleSided;
    desc.unlit = from.unlit;
    return desc;
}

}  // namespace

MaterialUploads::~MaterialUploads() {
    for (MaterialHandle material : materials_)
        if (material) renderer_.destroy(material);
    for (const auto& [use, image] : images_) renderer_.destroy(image);
}

ImageDesc MaterialUploads::imageDesc(int image, bool srgb) const {
    const assets::Image& from = model_.images[size_t(image)];
    ImageDesc desc;
    desc.label = from.name;
    desc.width = from.width;
    desc.height = from.height;
    desc.srgb = srgb;
    desc.pixels = from.pixels;
    return desc;
}

Result<ImageHandle> MaterialUploads::findImage(int image, bool srgb) {
    const auto found = images_.find({image, srgb});
    if (found != images_.end()) return found->second;
    auto handle = renderer_.createImage(imageDesc(image, srgb));
    if (handle) images_[{image, srgb}] = *handle;
    return handle;
}

Result<void> MaterialUploads::setTexture(const assets::TextureUse& use, bool srgb,
                                         TextureSlot& slot) {
    if (use.image < 0) return {};
    const auto image = findImage(use.image, srgb);
    if (!image) return tl::unexpected(image.error());
    slot = {*image, samplerOf(use.sampler), use.uvSet, use.offset, use.rotation, use.scale};
    return {};
}

Result<MaterialDesc> MaterialUploads::materialDesc(int material) {
    const assets::Material& from = model_.materials[size_t(material)];
    MaterialDesc desc = factorsOf(from);

    struct Use {
        const assets::TextureUse& from;
        bool srgb;
        TextureSlot& slot;
    };
    for (const Use& use : {Use{from.baseColorTexture, true, desc.baseColorTexture},
                           Use{from.metallicRoughnessTexture, false, desc.metallicRoughnessTexture},
                           Use{from.normalTexture, false, desc.normalTexture},
                           Use{from.occlusionTexture, false, desc.occlusionTexture},
                           Use{from.emissiveTexture, true, desc.emissiveTexture},
                           Use{from.transmissionTexture, false, desc.transmissionTexture}})
        if (auto set = setTexture(use.from, use.srgb, use.slot); !set)
            return tl::unexpected(set.error());

    return desc;
}

Result<MaterialHandle> MaterialUploads::find(int material) {
    if (material < 0) return MaterialHandle{};
    MaterialHandle& handle = materials_[size_t(material)];
    if (handle) return handle;
    const auto desc = materialDesc(material);
    if (!desc) return tl::unexpected(desc.error());
    auto created = renderer_.createMaterial(*desc);
    if (created) handle = *created;
    return created;
}

Result<void> MaterialUploads::describe(ResourceSink& sink) {
    for (const auto& [use, handle] : images_)
        if (auto ok = sink.image(handle, imageDesc(use.first, use.second)); !ok) return ok;
    for (size_t i = 0; i < materials_.size(); ++i) {
        if (!materials_[i]) continue;
        const auto desc = materialDesc(int(i));
        if (!desc) return tl::unexpected(desc.error());
        if (auto ok = sink.material(materials_[i], *desc); !ok) return ok;
    }
    return {};
}

}  // namespace rushlight

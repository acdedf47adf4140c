#include "renderer/resources/decal_store.h"

#include "renderer/materials/mip_chain.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kMaxSide = 16384;

struct Picture {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgba;
};

Result<void> check(std::string_view label, const char* what, const ImageDesc& image) {
    if (image.width == 0 && image.height == 0 && image.pixels.empty()) return {};
    const std::string size = std::to_string(image.width) + "x" + std::to_string(image.height);
    if (image.width == 0 || image.height == 0 || image.width > kMaxSide || image.height > kMaxSide)
        return fail(
            "decal material '" + std::string(label) + "'",
            std::string("its ") + what + " is " + size + "; each side must be 1 to 16,384 pixels.");
    if (image.pixels.size() != size_t(image.width) * image.height * 4)
        return fail("decal material '" + std::string(label) + "'",
                    std::string("its ") + what + " has " + std::to_string(image.pixels.size()) +
                        " bytes but " + size + " RGBA8 needs " +
                        std::to_string(size_t(image.width) * image.height * 4) + ".");
    return {};
}

/// At kDecalSide squared: halved while that keeps at least as many pixels, then bilinear.
std::vector<uint8_t> resample(const ImageDesc& image, bool srgb) {
    Picture from{image.width, image.height, {image.pixels.begin(), image.pixels.end()}};
    while (from.width >= 2 * kDecalSide && from.height >= 2 * kDecalSide) {
        from.rgba = halveImage(from.rgba, from.width, from.height, srgb);
        from.width /= 2;
        from.height /= 2;
    }
    if (from.width == kDecalSide && from.height == kDecalSide) return from.rgba;
    std::vector<uint8_t> to(size_t(kDecalSide) * kDecalSide * 4);
    for (uint32_t y = 0; y < kDecalSide; ++y)
        for (uint32_t x = 0; x < kDecalSide; ++x) {
            const auto place = [](uint32_t at, uint32_t size) {
                return std::clamp((float(at) + 0.5f) * float(size) / kDecalSide - 0.5f, 0.0f,
                                  float(size - 1));
            };
            const float u = place(x, from.width), v = place(y, from.height);
            const uint32_t x0 = uint32_t(u), y0 = uint32_t(v);
            const uint32_t x1 = std::min(x0 + 1, from.width - 1);
            const uint32_t y1 = std::min(y0 + 1, from.height - 1);
            for (uint32_t c = 0; c < 4; ++c) {
                const auto at = [&](uint32_t column, uint32_t row) {
                    return float(from.rgba[(size_t(row) * from.width + column) * 4 + c]);
                };
                const float top = std::lerp(at(x0, y0), at(x1, y0), u - float(x0));
                const float bottom = std::lerp(at(x0, y1), at(x1, y1), u - float(x0));
                to[(size_t(y) * kDecalSide + x) * 4 + c] = uint8_t(
                    std::lerp(top, bottom, v - float(y0)) + 0.5f);
            }
        }
    return to;
}

std::vector<uint8_t> filled(std::array<uint8_t, 4> texel) {
    std::vector<uint8_t> rgba(size_t(kDecalSide) * kDecalSide * 4);
    for (size_t i = 0; i < rgba.size(); ++i) rgba[i] = texel[i % 4];
    return rgba;
}

std::vector<uint8_t> colorOf(const DecalMaterialDesc& desc) {
    return desc.baseColor.pixels.empty() ? filled({255, 255, 255, 255})
                                         : resample(desc.baseColor, true);
}

std::vector<uint8_t> detailOf(const DecalMaterialDesc& desc) {
    std::vector<uint8_t> detail = filled({128, 128, 255, 255});
    const auto take = [&](const ImageDesc& image, uint32_t from, uint32_t to) {
        if (image.pixels.empty()) return;
        const std::vector<uint8_t> pixels = resample(image, false);
        for (size_t i = 0; i < pixels.size(); i += 4)
            for (uint32_t c = 0; c < 2; ++c) detail[i + to + c] = pixels[i + from + c];
    };
    take(desc.normal, 0, 0);
    take(desc.metallicRoughness, 1, 2);
    return detail;
}

std::vector<std::vector<uint8_t>> chainOf(std::vector<uint8_t> top, bool srgb) {
    std::vector<std::vector<uint8_t>> levels{std::move(top)};
    for (uint32_t side = kDecalSide; side > 1; side /= 2)
        levels.push_back(halveImage(levels.back(), side, side, srgb));
    return levels;
}

}  // namespace

DecalStore::~DecalStore() {
    for (TextureHandle array : arrays_)
        if (array) device_.destroy(array);
}

Result<DecalMaterialHandle> DecalStore::create(const DecalMaterialDesc& desc) {
    for (const auto& [what, image] :
         {std::pair("base colour", &desc.baseColor), std::pair("normal map", &desc.normal),
          std::pair("metallic-roughness map", &desc.metallicRoughness)})
        if (auto ok = check(desc.label, what, *image); !ok) return tl::unexpected(ok.error());
    if (freeLayers_.empty() && layers_.size() == kMaxDecalMaterials)
        return fail("decal material '" + std::string(desc.label) + "'",
                    "there are " + std::to_string(kMaxDecalMaterials) + " already; no more fit.");
    const uint32_t layer = freeLayers_.empty() ? uint32_t(layers_.size()) : freeLayers_.back();
    if (layer >= capacity_)
        if (auto ok = grow(std::max(4u, std::min(capacity_ * 2, kMaxDecalMaterials))); !ok)
            return tl::unexpected(ok.error());
    if (freeLayers_.empty())
        layers_.emplace_back();
    else
        freeLayers_.pop_back();
    layers_[layer] = {chainOf(colorOf(desc), true), chainOf(detailOf(desc), false)};
    upload(layer);
    return materials_.insert(layer);
}

void DecalStore::destroy(DecalMaterialHandle handle) {
    const uint32_t* layer = materials_.find(handle);
    if (!layer) return;
    freeLayers_.push_back(*layer);
    layers_[*layer] = {};
    materials_.erase(handle);
}

Result<void> DecalStore::grow(uint32_t layers) {
    std::array<TextureHandle, 2> larger;
    for (uint32_t i = 0; i < 2; ++i) {
        TextureDesc desc;
        desc.label = i == 0 ? "decal-color" : "decal-detail";
        desc.kind = TextureKind::texture2dArray;
        desc.format = i == 0 ? Format::rgba8Srgb : Format::rgba8;
        desc.width = desc.height = kDecalSide;
        desc.layers = layers;
        desc.mipLevels = mipLevelCount(kDecalSide, kDecalSide);
        auto texture = device_.createTexture(desc);
        if (!texture) {
            if (larger[0]) device_.destroy(larger[0]);
            return tl::unexpected(texture.error());
        }
        larger[i] = *texture;
    }
    for (TextureHandle array : arrays_)
        if (array) device_.destroy(array);
    arrays_ = larger;
    capacity_ = layers;
    for (uint32_t layer = 0; layer < layers_.size(); ++layer) upload(layer);
    return {};
}

void DecalStore::upload(uint32_t layer) {
    for (uint32_t i = 0; i < 2; ++i)
        for (uint32_t level = 0; level < layers_[layer][i].size(); ++level)
            device_.write(arrays_[i], {level, layer, 1, kDecalSide >> level, kDecalSide >> level},
                          std::as_bytes(std::span(layers_[layer][i][level])));
}

}  // namespace rushlight

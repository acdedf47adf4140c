#include "renderer/resources/light_pattern_store.h"

#include "interop/light_patterns.h"
#include "renderer/geometry/half.h"
#include "renderer/materials/mip_chain.h"

#include <algorithm>

namespace rushlight {
namespace {

constexpr uint32_t kSide = RL_LIGHT_PATTERN_SIDE;

std::vector<vec3> halved(const std::vector<vec3>& from, uint32_t side) {
    std::vector<vec3> to;
    to.reserve(size_t(side / 2) * (side / 2));
    for (uint32_t y = 0; y < side; y += 2)
        for (uint32_t x = 0; x < side; x += 2) {
            const size_t at = size_t(y) * side + x;
            to.push_back(0.25f * (from[at] + from[at + 1] + from[at + side] + from[at + side + 1]));
        }
    return to;
}

std::vector<uint16_t> packed(const std::vector<vec3>& texels) {
    std::vector<uint16_t> halves;
    halves.reserve(texels.size() * 4);
    for (const vec3& texel : texels)
        for (const float value : {texel.x, texel.y, texel.z, 1.0f}) halves.push_back(toHalf(value));
    return halves;
}

}  // namespace

LightPatternStore::~LightPatternStore() {
    if (array_) device_.destroy(array_);
}

Result<LightProfileHandle> LightPatternStore::create(const LightProfileDesc& desc) {
    const auto pattern = LightPattern::make(desc);
    if (!pattern) return tl::unexpected(pattern.error());
    const auto entry = add(*pattern);
    if (!entry) return tl::unexpected(entry.error());
    return profiles_.insert(*entry);
}

Result<LightCookieHandle> LightPatternStore::create(const LightCookieDesc& desc) {
    const auto pattern = LightPattern::make(desc);
    if (!pattern) return tl::unexpected(pattern.error());
    const auto entry = add(*pattern);
    if (!entry) return tl::unexpected(entry.error());
    return cookies_.insert(*entry);
}

void LightPatternStore::destroy(LightProfileHandle handle) {
    if (const Entry* entry = profiles_.find(handle)) release(entry->layer);
    profiles_.erase(handle);
}

void LightPatternStore::destroy(LightCookieHandle handle) {
    if (const Entry* entry = cookies_.find(handle)) release(entry->layer);
    cookies_.erase(handle);
}

void LightPatternStore::release(uint32_t layer) {
    freeLayers_.push_back(layer);
    layers_[layer] = {};
}

Result<LightPatternStore::Entry> LightPatternStore::add(const LightPattern& pattern) {
    if (freeLayers_.empty() && layers_.size() == kMaxLightPatterns)
        return fail("lighting", "there are " + std::to_string(kMaxLightPatterns) +
                                    " light profiles and cookies already; no more fit.");
    const uint32_t layer = freeLayers_.empty() ? uint32_t(layers_.size()) : freeLayers_.back();
    if (layer >= capacity_)
        if (auto ok = grow(std::max(2u, std::min(capacity_ * 2, kMaxLightPatterns))); !ok)
            return tl::unexpected(ok.error());
    if (freeLayers_.empty())
        layers_.emplace_back();
    else
        freeLayers_.pop_back();
    std::vector<vec3> texels = pattern.texels;
    for (uint32_t side = kSide; side > 0; side /= 2) {
        layers_[layer].push_back(packed(texels));
        if (side > 1) texels = halved(texels, side);
    }
    upload(layer);
    return Entry{layer, pattern.perRadian};
}

Result<void> LightPatternStore::grow(uint32_t layers) {
    if (!sampler_) {
        SamplerDesc sampler;
        sampler.wrapV = TextureWrap::clampToEdge;  // and repeated along the turn
        sampler_ = device_.createSampler(sampler);
    }
    TextureDesc desc;
    desc.label = "light-patterns";
    desc.kind = TextureKind::texture2dArray;
    desc.format = Format::rgba16f;
    desc.width = desc.height = kSide;
    desc.layers = layers;
    desc.mipLevels = mipLevelCount(kSide, kSide);
    const auto larger = device_.createTexture(desc);
    if (!larger) return tl::unexpected(larger.error());
    if (array_) device_.destroy(array_);
    array_ = *larger;
    capacity_ = layers;
    for (uint32_t layer = 0; layer < layers_.size(); ++layer) upload(layer);
    return {};
}

void LightPatternStore::upload(uint32_t layer) {
    for (uint32_t level = 0; level < layers_[layer].size(); ++level)
        device_.write(array_, {level, layer, 1, kSide >> level, kSide >> level},
                      std::as_bytes(std::span(layers_[layer][level])));
}

}  // namespace rushlight

#include "renderer/raytrace/ray_image.h"

#include "renderer/materials/mip_chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace rushlight {
namespace {

std::array<float, 256> makeSrgbTable() {
    std::array<float, 256> table;
    for (uint32_t i = 0; i < 256; ++i) {
        const float x = float(i) / 255;
        table[i] = x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
    }
    return table;
}

const std::array<float, 256> kLinearFromSrgb = makeSrgbTable();

uint32_t wrapTexel(int64_t texel, uint32_t size, TextureWrap wrap) {
    const int64_t n = size;
    if (wrap == TextureWrap::clampToEdge) return uint32_t(std::clamp<int64_t>(texel, 0, n - 1));
    if (wrap == TextureWrap::repeat) return uint32_t(((texel % n) + n) % n);
    const int64_t folded = ((texel % (2 * n)) + 2 * n) % (2 * n);
    return uint32_t(folded < n ? folded : 2 * n - 1 - folded);
}

struct Bilinear {
    uint32_t x0, x1, y0, y1;
    vec2 f;
};

// Texture coordinates beyond a million have no fraction left; what is not finite counts as zero.
Bilinear place(const TextureSlot& slot, vec2 uv, uvec2 size) {
    const auto clean = [](float x) { return std::abs(x) < 1e6f ? x : 0.0f; };
    const vec2 at = vec2(clean(uv.x), clean(uv.y)) * vec2(size) - 0.5f;
    const vec2 low = glm::floor(at);
    const TextureWrap u = slot.sampler.wrapU, v = slot.sampler.wrapV;
    const int64_t x = int64_t(low.x), y = int64_t(low.y);
    return {wrapTexel(x, size.x, u), wrapTexel(x + 1, size.x, u), wrapTexel(y, size.y, v),
            wrapTexel(y + 1, size.y, v), at - low};
}

template <class T>
T mix(const Bilinear& b, const T& a00, const T& a10, const T& a01, const T& a11) {
    const T low = a00 + (a10 - a00) * b.f.x, high = a01 + (a11 - a01) * b.f.x;
    return low + (high - low) * b.f.y;
}

}  // namespace

vec2 transformUv(const TextureSlot& slot, const vec2& uv) {
    const float c = std::cos(slot.rotation), s = std::sin(slot.rotation);
    const vec2 scaled = uv * slot.scale;
    return vec2(c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x) + slot.offset;
}

Result<RayImage> RayImage::create(const ImageDesc& desc) {
    const size_t pixels = size_t(desc.width) * desc.height;
    if (pixels == 0 || desc.width > 16384 || desc.height > 16384 ||
        desc.pixels.size() != pixels * 4)
        return fail("image '" + std::string(desc.label) + "'",
                    "it is " + std::to_string(desc.width) + "x" + std::to_string(desc.height) +
                        " with " + std::to_string(desc.pixels.size()) +
                        " bytes; each side must be 1 to 16,384 pixels of 4 bytes.",
                    ErrorKind::wrongUse);
    RayImage image;
    image.srgb_ = desc.srgb;
    bool masks = false;
    for (size_t i = 3; i < desc.pixels.size() && !masks; i += 4) masks = desc.pixels[i] != 255;
    if (masks) {
        image.alphaSize_ = {desc.width, desc.height};
        image.alpha_.resize(pixels);
        for (size_t i = 0; i < pixels; ++i) image.alpha_[i] = desc.pixels[i * 4 + 3];
    }
    image.size_ = {desc.width, desc.height};
    image.colors_.assign(desc.pixels.begin(), desc.pixels.end());
    while (std::max(image.size_.x, image.size_.y) > kMostColorSide) {
        image.colors_ = halveImage(image.colors_, image.size_.x, image.size_.y, desc.srgb);
        image.size_ = glm::max(image.size_ / 2u, uvec2(1));
    }
    return image;
}

float RayImage::channel(uint8_t value) const {
    return srgb_ ? kLinearFromSrgb[value] : float(value) * (1.0f / 255);
}

vec4 RayImage::sample(const TextureSlot& slot, const vec2& uv) const {
    const Bilinear b = place(slot, transformUv(slot, uv), size_);
    const auto texel = [&](uint32_t x, uint32_t y) {
        const uint8_t* t = &colors_[(size_t(y) * size_.x + x) * 4];
        return vec4(channel(t[0]), channel(t[1]), channel(t[2]), float(t[3]) * (1.0f / 255));
    };
    return mix(b, texel(b.x0, b.y0), texel(b.x1, b.y0), texel(b.x0, b.y1), texel(b.x1, b.y1));
}

float RayImage::sampleAlpha(const TextureSlot& slot, const vec2& uv) const {
    if (alpha_.empty()) return 1;
    const Bilinear b = place(slot, transformUv(slot, uv), alphaSize_);
    const auto texel = [&](uint32_t x, uint32_t y) {
        return float(alpha_[size_t(y) * alphaSize_.x + x]) * (1.0f / 255);
    };
    return mix(b, texel(b.x0, b.y0), texel(b.x1, b.y0), texel(b.x0, b.y1), texel(b.x1, b.y1));
}

}  // namespace rushlight

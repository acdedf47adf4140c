#include "renderer/capture/breakdown/breakdown_pictures.h"

#include "renderer/replay/texel_picture.h"
#include "shaders/interop/tonemap.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace rushlight {
namespace {

uint8_t toByte(float value) {
    return uint8_t(std::lround(255 * std::clamp(std::isnan(value) ? 0 : value, 0.0f, 1.0f)));
}

vec3 toneMapped(const vec3& color, ToneMap toneMap) {
    switch (toneMap) {
        case ToneMap::none: break;
        case ToneMap::neutral: return interop::toneMapNeutral(color);
        case ToneMap::agx: return interop::toneMapAgx(color);
        case ToneMap::aces: return interop::toneMapAces(color);
    }
    return color;
}

struct Range {
    float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
    void add(float value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    bool isEmpty() const { return low > high; }
    /// 0 to 1 from low to high; 1 where they are equal.
    float place(float value) const { return high > low ? (value - low) / (high - low) : 1; }
};

/// One float a texel, rows from the top.
std::vector<float> scalars(const PassImage& image) {
    const size_t row = image.width;
    std::vector<float> values(row * image.height);
    for (size_t y = 0; y < image.height; ++y)
        std::memcpy(values.data() + y * row,
                    image.texels.data() + (image.height - 1 - y) * row * sizeof(float),
                    row * sizeof(float));
    return values;
}

void fillGrey(BreakdownPicture& picture, std::span<const float> greys) {
    picture.rgba8.resize(greys.size() * 4);
    for (size_t i = 0; i < greys.size(); ++i) {
        const uint8_t grey = toByte(greys[i]);
        for (size_t c = 0; c < 3; ++c) picture.rgba8[i * 4 + c] = grey;
        picture.rgba8[i * 4 + 3] = 255;
    }
}

/// The camera's depth, as metres by the logarithm; black where there is nothing.
void fillDistance(BreakdownPicture& picture, std::vector<float> depths, const PictureRules& rules) {
    Range range;
    for (float& depth : depths) {
        if (!(depth > 0)) continue;
        const float linear = depth * rules.depthDecode.x + rules.depthDecode.y;
        depth = std::log2(std::max(rules.perspective ? 1 / linear : linear, 1e-4f));
        range.add(depth);
        depth += 1e6f;  // told apart from nothing, which is 0
    }
    for (float& depth : depths)
        if (depth > 0) depth = 1 - range.place(depth - 1e6f) * (254.0f / 255);
    fillGrey(picture, depths);
    picture.readout = Readout::distance;
    picture.low = range.isEmpty() ? 0 : std::exp2(range.low);
    // The last grey before black is the farthest.
    picture.high = range.isEmpty() ? 0
                                   : std::exp2(range.low + (range.high - range.low) * 255 / 254);
}

/// A light's depth, or any values: from the smallest, not quite black, to the largest in white.
/// Zero is black.
void fillValues(BreakdownPicture& picture, std::vector<float> values, bool perspective) {
    if (values.size() == 1) picture.note += "Its value: " + std::to_string(values[0]) + ".";
    Range range;
    for (float& value : values) {
        if (perspective) value = std::sqrt(std::sqrt(value));  // such depths are small
        if (value != 0 && std::isfinite(value)) range.add(value);
    }
    for (float& value : values)
        if (value != 0) value = 0.1f + 0.9f * range.place(value);
    fillGrey(picture, values);
    picture.readout = Readout::unit;
}

void fillDirections(BreakdownPicture& picture, std::span<const float> rgba) {
    picture.rgba8.resize(rgba.size());
    for (size_t i = 0; i < rgba.size(); ++i)
        picture.rgba8[i] = i % 4 == 3 ? 255 : toByte(rgba[i] * 0.5f + 0.5f);
    picture.readout = Readout::direction;
}

}  // namespace

std::vector<uint8_t> displayedRadiance(std::span<const float> rgba, const PictureRules& rules) {
    std::vector<uint8_t> picture(rgba.size());
    for (size_t i = 0; i + 3 < rgba.size(); i += 4) {
        vec3 color(rgba[i], rgba[i + 1], rgba[i + 2]);
        for (int c = 0; c < 3; ++c)
            if (!(color[c] > 0)) color[c] = 0;
        const vec3 shown = toneMapped(color * rules.exposure, rules.toneMap);
        for (int c = 0; c < 3; ++c)
            picture[i + size_t(c)] = toByte(interop::encodeSrgb(std::clamp(shown[c], 0.0f, 1.0f)));
        picture[i + 3] = 255;
    }
    return picture;
}

std::vector<uint8_t> factorPicture(std::span<const float> rgba) {
    std::vector<uint8_t> picture(rgba.size());
    std::ranges::transform(rgba, picture.begin(), toByte);
    return picture;
}

void fillPicture(BreakdownPicture& picture, PassImage& image, const PictureRules& rules) {
    picture.width = image.width;
    picture.height = image.height;
    const std::string_view name = image.name;
    if (image.format == Format::depth32f || image.format == Format::r32f) {
        std::vector<float> values = scalars(image);
        picture.exact = true;
        if (name == "depth" || (name.starts_with("pyramid") && name.ends_with("depth")))
            fillDistance(picture, std::move(values), rules);
        else
            fillValues(picture, std::move(values), name.starts_with("shadow-atlas"));
        return;
    }
    const TexelPicture exact = exactPicture(
        {image.format, image.width, image.height, std::move(image.texels)}, false);
    if (!exact.rgba8.empty()) {
        picture.rgba8 = exact.rgba8;
        for (size_t i = 3; i < picture.rgba8.size(); i += 4) picture.rgba8[i] = 255;
    } else if (image.format == Format::rgba16f || image.format == Format::r11g11b10f) {
        picture.rgba8 = displayedRadiance(exact.rgba32f, rules);
    } else {
        fillDirections(picture, exact.rgba32f);
    }
}

std::vector<uint8_t> culledPicture(std::span<const uint8_t> frame, std::span<const uint8_t> visible,
                                   std::span<const uint8_t> unhidden,
                                   std::span<const uint8_t> all) {
    std::vector<uint8_t> picture(frame.size(), 255);
    const auto differs = [&](std::span<const uint8_t> other, size_t at) {
        return std::memcmp(&frame[at], &other[at], 3) != 0;
    };
    const auto paint = [&](size_t at, uint8_t r, uint8_t g, uint8_t b) {
        picture[at] = r, picture[at + 1] = g, picture[at + 2] = b;
    };
    for (size_t at = 0; at + 3 < frame.size(); at += 4) {
        const auto grey = uint8_t(
            (54 * frame[at] + 183 * frame[at + 1] + 19 * frame[at + 2]) / 256 * 2 / 5 + 20);
        if (differs(visible, at))
            paint(at, 60, 220, 110);
        else if (differs(unhidden, at))
            paint(at, 255, 70, 60);
        else if (differs(all, at))
            paint(at, 255, 210, 60);
        else
            paint(at, grey, grey, grey);
    }
    return picture;
}

void shrinkPicture(uint32_t& width, uint32_t& height, std::vector<uint8_t>& rgba, uint32_t side) {
    const uint32_t factor = (std::max(width, height) + side - 1) / side;
    if (factor < 2) return;
    const uint32_t w = std::max(width / factor, 1u), h = std::max(height / factor, 1u);
    std::vector<uint8_t> small(size_t(w) * h * 4);
    for (uint32_t y = 0; y < h; ++y)
        for (uint32_t x = 0; x < w; ++x)
            for (uint32_t c = 0; c < 4; ++c) {
                uint32_t sum = 0, count = 0;
                for (uint32_t v = y * factor; v < std::min((y + 1) * factor, height); ++v)
                    for (uint32_t u = x * factor; u < std::min((x + 1) * factor, width); ++u)
                        sum += rgba[(size_t(v) * width + u) * 4 + c], ++count;
                small[(size_t(y) * w + x) * 4 + c] = uint8_t(sum / std::max(count, 1u));
            }
    width = w;
    height = h;
    rgba = std::move(small);
}

}  // namespace rushlight

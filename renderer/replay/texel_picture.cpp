#include "renderer/replay/texel_picture.h"

#include <glm/gtc/color_space.hpp>
#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace rushlight {
namespace {

template <class T>
T load(const std::byte* texel, size_t index = 0) {
    T value;
    std::memcpy(&value, texel + index * sizeof value, sizeof value);
    return value;
}

float halfAt(const std::byte* texel, size_t index) {
    return glm::unpackHalf1x16(load<uint16_t>(texel, index));
}

bool hasBytes(Format format) {
    return format == Format::r8 || format == Format::rg8 || format == Format::rgba8 ||
           format == Format::rgba8Srgb;
}

bool hasOneChannel(Format format) {
    return isDepth(format) || format == Format::r8 || format == Format::r16f ||
           format == Format::r32f || format == Format::r16ui || format == Format::r32ui;
}

/// Missing channels are 0, alpha is 1.
vec4 decode(Format format, const std::byte* texel) {
    vec4 value(0, 0, 0, 1);
    const uint32_t channels = bytesPerTexel(format);
    switch (format) {
        case Format::none: break;
        case Format::r8:
        case Format::rg8:
        case Format::rgba8:
        case Format::rgba8Srgb:
            for (uint32_t c = 0; c < channels; ++c)
                value[int(c)] = float(load<uint8_t>(texel, c)) / 255.0f;
            break;
        case Format::rgb10a2: return glm::unpackUnorm3x10_1x2(load<uint32_t>(texel));
        case Format::r16f:
        case Format::rg16f:
        case Format::rgba16f:
            for (uint32_t c = 0; c < channels / 2; ++c) value[int(c)] = halfAt(texel, c);
            break;
        case Format::r11g11b10f: return vec4(glm::unpackF2x11_1x10(load<uint32_t>(texel)), 1);
        case Format::r32f:
        case Format::rg32f:
        case Format::rgba32f:
        case Format::depth32f:
            for (uint32_t c = 0; c < channels / 4; ++c) value[int(c)] = load<float>(texel, c);
            break;
        case Format::r16ui: value.x = float(load<uint16_t>(texel)); break;
        case Format::depth16: value.x = float(load<uint16_t>(texel)) / 65535.0f; break;
        case Format::r32ui:
        case Format::rgba32ui:
            for (uint32_t c = 0; c < channels / 4; ++c)
                value[int(c)] = float(load<uint32_t>(texel, c));
            break;
    }
    return value;
}

/// `visit(texel, index of the pixel from the top left)`.
template <class F>
void forEachTexel(const ReadbackImage& image, bool topRowFirst, F&& visit) {
    const size_t bytes = bytesPerTexel(image.format);
    for (size_t y = 0; y < image.height; ++y) {
        const size_t row = topRowFirst ? y : image.height - 1 - y;
        for (size_t x = 0; x < image.width; ++x)
            visit(image.bytes.data() + (row * image.width + x) * bytes, y * image.width + x);
    }
}

uint8_t toByte(float value) { return uint8_t(std::lround(255 * std::clamp(value, 0.0f, 1.0f))); }

}  // namespace

TexelPicture exactPicture(const ReadbackImage& image, bool topRowFirst) {
    TexelPicture picture{image.width, image.height, {}, {}};
    const size_t values = size_t(image.width) * image.height * 4;
    const bool bytes = hasBytes(image.format);
    if (bytes)
        picture.rgba8.resize(values);
    else
        picture.rgba32f.resize(values);
    forEachTexel(image, topRowFirst, [&](const std::byte* texel, size_t pixel) {
        const vec4 value = decode(image.format, texel);
        for (int c = 0; c < 4; ++c) {
            const size_t at = pixel * 4 + size_t(c);
            if (bytes)
                picture.rgba8[at] = toByte(value[c]);
            else
                picture.rgba32f[at] = value[c];
        }
    });
    return picture;
}

TexelPicture visiblePicture(const ReadbackImage& image, bool topRowFirst) {
    TexelPicture picture{image.width, image.height, {}, {}};
    picture.rgba8.resize(size_t(image.width) * image.height * 4);
    const bool grey = hasOneChannel(image.format), bytes = hasBytes(image.format);
    float largest = 0;
    if (grey)
        forEachTexel(image, topRowFirst, [&](const std::byte* texel, size_t) {
            if (const float x = decode(image.format, texel).x; std::isfinite(x))
                largest = std::max(largest, x);
        });
    forEachTexel(image, topRowFirst, [&](const std::byte* texel, size_t pixel) {
        vec4 value = decode(image.format, texel);
        for (int c = 0; c < 4; ++c)
            if (std::isnan(value[c])) value[c] = 0;
        if (grey)
            value = vec4(vec3(largest > 0 ? value.x / largest : 0), 1);
        else if (!bytes)
            value = vec4(glm::convertLinearToSRGB(glm::clamp(vec3(value), 0.0f, 1.0f)), 1);
        for (int c = 0; c < 3; ++c) picture.rgba8[pixel * 4 + size_t(c)] = toByte(value[c]);
        picture.rgba8[pixel * 4 + 3] = 255;
    });
    return picture;
}

}  // namespace rushlight

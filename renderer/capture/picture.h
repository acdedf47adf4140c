#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rushlight {

/// Pixels of somebody else, rows from the top, RGBA; exactly one of the spans is filled.
/// CapturedImage converts.
struct PictureView {
    uint32_t width = 0;
    uint32_t height = 0;
    std::span<const uint8_t> rgba8;  ///< sRGB, straight alpha
    std::span<const float> rgba32f;  ///< linear, premultiplied alpha
    std::string_view description;    ///< kept in the file; empty: none

    PictureView() = default;
    template <class Image>
    requires requires(const Image& i) { i.width, i.height, i.rgba8, i.rgba32f; }
    explicit PictureView(const Image& image)
        : width(image.width), height(image.height), rgba8(image.rgba8), rgba32f(image.rgba32f) {}
};

/// A picture from a file, rows from the top, four floats a pixel: RGBA with premultiplied alpha.
struct Picture {
    uint32_t width = 0;
    uint32_t height = 0;
    bool linear = false;  ///< float files: radiance. Otherwise sRGB-encoded values from 0 to 1.
    std::vector<float> rgba;
    std::string description = {};  ///< as PictureView's

    std::size_t pixelCount() const { return std::size_t(width) * height; }
};

/// As a lossless file with these pixels reads.
Picture pictureOf(const PictureView& view);

}  // namespace rushlight

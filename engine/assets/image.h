#pragma once
// Encoded images → pixels, through OpenImageIO.

#include "engine/assets/model.h"
#include "engine/core/math.h"
#include "engine/core/result.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace rushlight::assets {

struct ImageLimits {
    uint32_t maxSide = 16384;  ///< pixels
    uint64_t maxPixels = 1ull << 28;
};

/// PNG, JPEG or WebP to 8-bit RGBA: straight alpha, values as stored. `name` is for messages.
Result<Image> decodeImage(const std::string& name, std::span<const uint8_t> bytes,
                          const ImageLimits& limits = {});

/// The size an encoded image says it has, without decoding it.
Result<uvec2> readImageSize(const std::string& name, std::span<const uint8_t> bytes);

/// A magenta and black checker that stands for an image that could not be had.
Image makeMissingImage(const std::string& name);

/// Linear radiance, rows from the top; finite and not negative.
struct HdrImage {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<vec3> pixels;
};

/// Radiance .hdr and OpenEXR.
Result<HdrImage> loadHdr(const std::filesystem::path& path, const ImageLimits& limits = {});

}  // namespace rushlight::assets

#pragma once

#include "renderer/rhi/device.h"

namespace rushlight {

/// Pixels for a picture file, rows from the top; one of the vectors is filled.
struct TexelPicture {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgba8;  ///< sRGB
    std::vector<float> rgba32f;  ///< linear
};

/// `image` as it is: formats of 8 bits a channel give rgba8, all others rgba32f.
TexelPicture exactPicture(const ReadbackImage& image, bool topRowFirst);

/// Something to look at: opaque, 8 bits. Colours above one are white; images of one channel are
/// grey, from zero in black to their largest value in white (reversed depth: what is nearest).
TexelPicture visiblePicture(const ReadbackImage& image, bool topRowFirst);

}  // namespace rushlight

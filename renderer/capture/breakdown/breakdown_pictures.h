#pragma once
// From what passes wrote to pictures that can be looked at.

#include "renderer/capture/breakdown/breakdown.h"
#include "renderer/geometry/view_math.h"

namespace rushlight {

/// How radiance becomes a picture, and device depth a distance.
struct PictureRules {
    float exposure = 1;
    ToneMap toneMap = ToneMap::neutral;
    vec2 depthDecode{0, 1};  ///< CameraMatrices
    bool perspective = true;
};

/// Linear RGBA, rows from the top.
std::vector<uint8_t> displayedRadiance(std::span<const float> rgba, const PictureRules& rules);

/// Factors from 0 to 1, as they are.
std::vector<uint8_t> factorPicture(std::span<const float> rgba);

/// Pixels, readout and range of `picture`, from the image's texels, which are taken.
void fillPicture(BreakdownPicture& picture, PassImage& image, const PictureRules& rules);

/// The frame in dark grey, with the boxes of what is drawn in green, of what is too small in
/// yellow, of what is hidden in red. All are RGBA of one size: the frame; it with boxes of what is
/// visible; also of what is hidden; of all in view.
std::vector<uint8_t> culledPicture(std::span<const uint8_t> frame, std::span<const uint8_t> visible,
                                   std::span<const uint8_t> unhidden, std::span<const uint8_t> all);

/// At most `side` pixels a side, by whole factors, as means.
void shrinkPicture(uint32_t& width, uint32_t& height, std::vector<uint8_t>& rgba, uint32_t side);

}  // namespace rushlight

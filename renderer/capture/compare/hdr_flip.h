#pragma once
// Andersson, Nilsson, Shirley, Akenine-Möller, "Visualizing Errors in Rendered High Dynamic Range
// Images", Eurographics 2021: FLIP of radiance, as the worst of what is seen at every exposure at
// which the reference shows something.

#include "renderer/capture/compare/flip.h"

namespace rushlight {

/// Exposures in stops, evenly spaced: at the first the brightest pixel of the reference, at the
/// last its median pixel is tone mapped to 0.85.
struct ExposureRange {
    static constexpr uint32_t kMost = 48;  ///< what is wider has steps of more than a stop

    float first = 0;
    float last = 0;
    uint32_t count = 2;

    float stops(uint32_t i) const { return first + (last - first) * float(i) / float(count - 1); }
};

/// Pixels that are black or not finite do not count; without any other the range is that of white.
ExposureRange exposureRange(std::span<const vec3> reference);

/// For every pixel 0 to 1, as flipErrors. Both pictures: linear Rec.709, `width` * `height`; what
/// is negative or not a number is seen as black.
Plane hdrFlipErrors(std::span<const vec3> reference, std::span<const vec3> test, uint32_t width,
                    uint32_t height, float pixelsPerDegree);

}  // namespace rushlight

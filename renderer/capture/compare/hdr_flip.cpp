#include "renderer/capture/compare/hdr_flip.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rushlight {
namespace {

// Narkowicz, "ACES Filmic Tone Mapping Curve", 2015: (a x² + b x) / (c x² + d x + e), of 0.6 times
// the radiance as the paper has it (section 3.2).
constexpr float kBefore = 0.6f;
constexpr float kA = 2.51f, kB = 0.03f, kC = 2.43f, kD = 0.59f, kE = 0.14f;

float toneMapped(float radiance) {
    if (!(radiance > 0)) return 0;
    const float x = std::min(radiance, 1e6f) * kBefore;  // far beyond white, and its square is
                                                         // finite
    return std::min((kA * x * x + kB * x) / (kC * x * x + kD * x + kE), 1.0f);
}

/// The radiance that is tone mapped to `value`: the positive root of the curve's quadratic
/// equation.
float radianceOf(float value) {
    const float a = value * kC - kA, b = value * kD - kB, c = value * kE;
    return (-b - std::sqrt(b * b - 4 * a * c)) / (2 * a) / kBefore;
}

float luminance(const vec3& c) { return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b; }

std::vector<vec3> exposed(std::span<const vec3> picture, float stops) {
    const float factor = std::exp2(stops);
    std::vector<vec3> shown(picture.size());
    for (size_t i = 0; i < shown.size(); ++i)
        for (int c = 0; c < 3; ++c) shown[i][c] = toneMapped(picture[i][c] * factor);
    return shown;
}

}  // namespace

ExposureRange exposureRange(std::span<const vec3> reference) {
    constexpr float kTarget = 0.85f;
    std::vector<float> bright;
    for (const vec3& pixel : reference)
        if (const float y = luminance(pixel); y > 0 && std::isfinite(y)) bright.push_back(y);
    if (bright.empty()) bright.push_back(1);
    const auto middle = bright.begin() + ptrdiff_t(bright.size() / 2);
    std::nth_element(bright.begin(), middle, bright.end());
    const float below = bright.size() % 2 ? *middle : *std::max_element(bright.begin(), middle);
    const float median = 0.5f * (below + *middle),
                highest = *std::max_element(middle, bright.end());
    ExposureRange range;
    range.first = std::log2(radianceOf(kTarget)) - std::log2(highest);
    range.last = std::log2(radianceOf(kTarget)) - std::log2(median);
    const float wide = std::ceil(range.last - range.first);
    range.count = uint32_t(std::clamp(wide, 2.0f, float(ExposureRange::kMost)));
    return range;
}

Plane hdrFlipErrors(std::span<const vec3> reference, std::span<const vec3> test, uint32_t width,
                    uint32_t height, float pixelsPerDegree) {
    const ExposureRange range = exposureRange(reference);
    Plane worst(width, height);
    for (uint32_t i = 0; i < range.count; ++i) {
        const float stops = range.stops(i);
        const Plane errors = flipErrors(exposed(reference, stops), exposed(test, stops), width,
                                        height, pixelsPerDegree);
        for (size_t p = 0; p < worst.values.size(); ++p)
            worst.values[p] = std::max(worst.values[p], errors.values[p]);
        if (range.first == range.last) break;
    }
    return worst;
}

}  // namespace rushlight

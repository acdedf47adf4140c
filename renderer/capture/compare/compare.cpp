#include "renderer/capture/compare/compare.h"

#include "renderer/capture/compare/hdr_flip.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rushlight {
namespace {

bool isOpaque(const Picture& picture) {
    for (size_t i = 3; i < picture.rgba.size(); i += 4)
        if (picture.rgba[i] != 1) return false;
    return true;
}

std::string sizeText(const Picture& p) {
    return std::to_string(p.width) + "x" + std::to_string(p.height);
}

/// Two infinities of one sign are equal; a NaN on one side alone is an infinite error.
double difference(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    const double d = std::abs(double(a) - double(b));
    return std::isnan(d) ? std::numeric_limits<double>::infinity() : d;
}

void measureErrors(const Picture& a, const Picture& b, Comparison& result) {
    const size_t channels = isOpaque(a) && isOpaque(b) ? 3 : 4;
    double sum = 0;
    double squares = 0;
    result.errors = Plane(a.width, a.height);
    for (size_t i = 0; i < a.rgba.size(); i += 4)
        for (size_t c = 0; c < channels; ++c) {
            const double d = difference(a.rgba[i + c], b.rgba[i + c]);
            double& worst = result.errors.values[i / 4];
            worst = std::max(worst, d);
            result.maxError = std::max(result.maxError, d);
            sum += d;
            squares += d * d;
        }
    const double count = double(a.pixelCount() * channels);
    result.meanError = sum / count;
    result.psnr = squares == 0 ? std::numeric_limits<double>::infinity()
                               : -10 * std::log10(squares / count);
}

double alphaOverlap(const Picture& a, const Picture& b) {
    size_t both = 0, either = 0;
    for (size_t i = 3; i < a.rgba.size(); i += 4) {
        const bool inA = a.rgba[i] >= 0.5f, inB = b.rgba[i] >= 0.5f;
        both += inA && inB;
        either += inA || inB;
    }
    return either ? double(both) / double(either) : 1;
}

float cut(float value) { return value >= 0 ? std::min(value, 1.0f) : 0.0f; }  // NaN becomes 0

float linearFromSrgb(float v) {
    return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

float srgbFromLinear(float v) {
    return v <= 0.0031308f ? v * 12.92f : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
}

/// Over black; radiance, or what a display shows.
std::vector<vec3> linearColors(const Picture& picture) {
    std::vector<vec3> colors(picture.pixelCount());
    for (size_t i = 0; i < colors.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const float value = picture.rgba[i * 4 + size_t(c)];
            colors[i][c] = picture.linear ? value : linearFromSrgb(cut(value));
        }
    return colors;
}

/// Rec.709 luma of the sRGB values.
Plane luma(const Picture& picture) {
    Plane plane(picture.width, picture.height);
    for (size_t i = 0; i < plane.values.size(); ++i) {
        float rgb[3];
        for (size_t c = 0; c < 3; ++c) {
            const float value = cut(picture.rgba[i * 4 + c]);
            rgb[c] = picture.linear ? srgbFromLinear(value) : value;
        }
        plane.values[i] = 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2];
    }
    return plane;
}

Plane product(const Plane& a, const Plane& b) {
    Plane result = a;
    for (size_t i = 0; i < result.values.size(); ++i) result.values[i] *= b.values[i];
    return result;
}

/// Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to Structural
/// Similarity", IEEE TIP 2004: an 11x11 Gaussian window of σ = 1.5, K1 = 0.01, K2 = 0.03; the mean
/// over windows inside the picture (over all pixels when it is smaller than a window).
double structuralSimilarity(const Plane& x, const Plane& y) {
    constexpr int kRadius = 5;
    constexpr double kC1 = 0.01 * 0.01;
    constexpr double kC2 = 0.03 * 0.03;
    const Kernel window = normalized(gaussian(1.5f, kRadius));
    const auto mean = [&](const Plane& plane) { return filtered(plane, window, window); };
    const Plane mx = mean(x), my = mean(y);
    const Plane mxx = mean(product(x, x)), myy = mean(product(y, y)), mxy = mean(product(x, y));

    const bool fits = x.width > 2 * kRadius && x.height > 2 * kRadius;
    const uint32_t border = fits ? kRadius : 0;
    double sum = 0;
    for (uint32_t row = border; row < x.height - border; ++row)
        for (uint32_t column = border; column < x.width - border; ++column) {
            const size_t i = size_t(row) * x.width + column;
            const double ux = mx.values[i], uy = my.values[i];
            const double vx = mxx.values[i] - ux * ux, vy = myy.values[i] - uy * uy;
            const double covariance = mxy.values[i] - ux * uy;
            sum += (2 * ux * uy + kC1) * (2 * covariance + kC2) /
                   ((ux * ux + uy * uy + kC1) * (vx + vy + kC2));
        }
    return sum / (double(x.width - 2 * border) * double(x.height - 2 * border));
}

}  // namespace

Result<Comparison> comparePictures(const Picture& a, const Picture& b, const std::string& objectA,
                                   const std::string& objectB, const CompareOptions& options) {
    if (a.width != b.width || a.height != b.height)
        return fail(objectB, "The picture has " + sizeText(b) + " pixels and " + objectA + " has " +
                                 sizeText(a) + "; pictures of one size are compared.");
    if (a.linear != b.linear)
        return fail(objectB, std::string("The picture is ") + (b.linear ? "linear" : "sRGB") +
                                 " and " + objectA + " is " + (a.linear ? "linear" : "sRGB") +
                                 "; pictures of one kind are compared.");
    Comparison result;
    measureErrors(a, b, result);
    result.ssim = structuralSimilarity(luma(a), luma(b));
    result.alphaOverlap = alphaOverlap(a, b);
    const auto flip = a.linear ? hdrFlipErrors : flipErrors;
    result.flipErrors = flip(linearColors(a), linearColors(b), a.width, a.height,
                             options.pixelsPerDegree);
    double sum = 0;
    for (double error : result.flipErrors.values) sum += error;
    result.flip = sum / double(a.pixelCount());
    return result;
}

}  // namespace rushlight

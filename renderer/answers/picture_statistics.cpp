#include "renderer/answers/picture_statistics.h"

#include "interop/tonemap.h"
#include "renderer/geometry/view_math.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rushlight {
namespace {

// The eye tells such codes from black on no display in a lit room.
constexpr int kBlackCode = 6;
constexpr int kBlackOnBackground = 3;
constexpr int kWhiteCode = 250;

class Histogram {
public:
    void add(uint8_t code) { ++counts_[code], ++total_; }
    /// The code that a share of the pixels is not above.
    int below(double share) const {
        const double wanted = share * double(total_);
        uint64_t sum = 0;
        for (int code = 0; code < 256; ++code)
            if (double(sum += counts_[size_t(code)]) >= wanted && sum > 0) return code;
        return 0;
    }

private:
    std::array<uint64_t, 256> counts_{};
    uint64_t total_ = 0;
};

vec3 linearOf(const CapturedImage& image, size_t pixel) {
    const float* p = &image.rgba32f[pixel * 4];
    return {p[0], p[1], p[2]};
}

bool isDrawn(const LookPictures& in, size_t pixel) {
    if (in.depth->rgba32f[pixel * 4] > 0) return true;
    const vec3 a = linearOf(*in.linear, pixel), b = linearOf(*in.background, pixel);
    return glm::length(a - b) > 1e-3f * glm::length(b) + 1e-12f;
}

float percentile(std::vector<float>& values, double share) {
    if (values.empty()) return 0;
    const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::ranges::nth_element(values, at);
    return *at;
}

}  // namespace

bool FrameLook::isBlack() const {
    if (drawn >= 0.01f && brightestDrawn <= kBlackOnBackground) return true;
    return std::max(brightest, drawn >= 0.0005f ? brightestDrawn : 0) <= kBlackCode;
}

bool FrameLook::isMostlyBlack() const { return drawn >= 0.01f && common <= kBlackCode; }

bool FrameLook::isWhite() const { return drawn >= 0.01f && darkest >= kWhiteCode; }

const char* FrameLook::name() const {
    if (notFinite >= 0.001f) return "not finite";
    if (isEmpty()) return "empty";
    if (isBlack()) return "black";
    if (isWhite()) return "white";
    if (isVeiled()) return "veiled";
    return isFlat() ? "of one colour" : "fine";
}

FrameLook lookOf(const LookPictures& in, bool expectsDrawn) {
    FrameLook look;
    look.expectsDrawn = expectsDrawn;
    const size_t count = size_t(in.display->width) * in.display->height;
    Histogram brightest, drawnBrightest, drawnDarkest;
    std::array<Histogram, 3> channels;
    std::vector<float> luminances;
    double logSum = 0, alpha = 0;
    size_t drawn = 0, positive = 0, notFinite = 0;
    for (size_t i = 0; i < count; ++i) {
        const uint8_t* codes = &in.display->rgba8[i * 4];
        brightest.add(std::max({codes[0], codes[1], codes[2]}));
        for (size_t c = 0; c < 3; ++c) channels[c].add(codes[c]);
        alpha += codes[3] / 255.0;
        const float luminance = interop::luminance(linearOf(*in.linear, i));
        const bool finite = std::isfinite(luminance);
        notFinite += !finite;
        if (!isDrawn(in, i)) continue;
        ++drawn;
        drawnBrightest.add(std::max({codes[0], codes[1], codes[2]}));
        drawnDarkest.add(std::min({codes[0], codes[1], codes[2]}));
        if (!finite) continue;
        luminances.push_back(luminance);
        if (luminance > 0) logSum += std::log(double(luminance)), ++positive;
    }
    look.drawn = float(double(drawn) / double(count));
    look.notFinite = float(double(notFinite) / double(count));
    look.brightest = brightest.below(0.99);
    look.brightestDrawn = drawnBrightest.below(0.99);
    look.common = drawnBrightest.below(0.75);
    look.darkest = drawn ? drawnDarkest.below(0.01) : 0;
    for (const Histogram& channel : channels)
        look.range = std::max(look.range, channel.below(0.995) - channel.below(0.005));
    look.luminance = percentile(luminances, 0.99);
    look.typical = positive ? float(std::exp(logSum / double(positive))) : 0;
    look.alpha = float(alpha / double(count));
    return look;
}

namespace {

/// Extinction along a way of `length` metres that begins at the height `low` and rises by `rise`:
/// the integral of Fog::density's exponential.
float opticalDepth(const Fog& fog, float low, float rise, float length) {
    const float k = fog.heightFalloff;
    const float atEye = fog.density * std::exp(-k * (low - fog.height));
    const float x = k * rise;
    return atEye * length * (std::abs(x) < 1e-4f ? 1 : (1 - std::exp(-x)) / x);
}

}  // namespace

float veiledBy(const Fog& fog, const View& view, const CapturedImage& depth) {
    const auto camera = makeCamera(view, float(depth.width) / float(depth.height));
    if (!camera || !(fog.density > 0)) return 0;
    size_t surfaces = 0, veiled = 0;
    for (uint32_t y = 0; y < depth.height; ++y)
        for (uint32_t x = 0; x < depth.width; ++x) {
            const float d = depth.rgba32f[(size_t(y) * depth.width + x) * 4];
            if (!(d > 0)) continue;
            const float linear = d * camera->depthDecode.x + camera->depthDecode.y;
            const vec2 uv((float(x) + 0.5f) / float(depth.width),
                          1 - (float(y) + 0.5f) / float(depth.height));
            const vec3 way = camera->relativePosition(uv,
                                                      camera->perspective ? 1 / linear : linear);
            ++surfaces;
            veiled += opticalDepth(fog, camera->position.y, way.y, glm::length(way)) >
                      std::log(255.0f);
        }
    return surfaces ? float(double(veiled) / double(surfaces)) : 0;
}

SurfaceLook surfaceOf(const CapturedImage& baseColor, const CapturedImage& metallic,
                      const CapturedImage& depth) {
    SurfaceLook look;
    Histogram colors;
    double metal = 0;
    size_t count = 0;
    for (size_t i = 0; i < size_t(depth.width) * depth.height; ++i) {
        if (!(depth.rgba32f[i * 4] > 0)) continue;
        const uint8_t* codes = &baseColor.rgba8[i * 4];
        colors.add(std::max({codes[0], codes[1], codes[2]}));
        metal += metallic.rgba8[i * 4] / 255.0;
        ++count;
    }
    if (count == 0) return look;
    look.baseColor = interop::decodeSrgb(float(colors.below(0.99)) / 255);
    look.metallic = float(metal / double(count));
    return look;
}

}  // namespace rushlight

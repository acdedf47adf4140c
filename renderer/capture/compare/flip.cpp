#include "renderer/capture/compare/flip.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rushlight {
namespace {

// ---- colour spaces (section 4.1)
// ---------------------------------------------------------------------------------

vec3 xyzOf(float x, float y) { return {x / y, 1, (1 - x - y) / y}; }

/// From the chromaticities of sRGB's primaries and of D65 (IEC 61966-2-1).
mat3 makeXyzFromRgb() {
    const mat3 primaries(xyzOf(0.64f, 0.33f), xyzOf(0.30f, 0.60f), xyzOf(0.15f, 0.06f));
    const vec3 scale = glm::inverse(primaries) * xyzOf(0.31271f, 0.32902f);
    return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
}

const mat3 kXyzFromRgb = makeXyzFromRgb();
const mat3 kRgbFromXyz = glm::inverse(kXyzFromRgb);
const vec3 kWhite = kXyzFromRgb * vec3(1);

/// The linear opponent space in which the eye's spatial filters work.
vec3 opponentFromRgb(const vec3& rgb) {
    const vec3 t = kXyzFromRgb * rgb / kWhite;
    return {116 * t.y - 16, 500 * (t.x - t.y), 200 * (t.y - t.z)};
}

vec3 rgbFromOpponent(const vec3& o) {
    const float y = (o.x + 16) / 116;
    return kRgbFromXyz * (vec3(y + o.y / 500, y, y - o.z / 200) * kWhite);
}

vec3 labFromRgb(const vec3& rgb) {
    constexpr float kDelta = 6.0f / 29;
    vec3 f = kXyzFromRgb * rgb / kWhite;
    for (int i = 0; i < 3; ++i)
        f[i] = f[i] > kDelta * kDelta * kDelta ? std::cbrt(f[i])
                                               : f[i] / (3 * kDelta * kDelta) + 4.0f / 29;
    return {116 * f.y - 16, 500 * (f.x - f.y), 200 * (f.y - f.z)};
}

/// Colours look less saturated where they are dark (Hunt effect, equation 8).
vec3 huntAdjusted(const vec3& lab) { return {lab.x, 0.01f * lab.x * lab.y, 0.01f * lab.x * lab.z}; }

/// HyAB: city-block between lightness and chroma (equation 9).
float hyabDistance(const vec3& a, const vec3& b) {
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// ---- colour difference (sections 4.1 and 4.2)
// --------------------------------------------------------------------

/// A contrast sensitivity function as a sum of Gaussians a √(π/b) exp(-π² d²/b), d in degrees
/// (equation 4, table 1).
struct Gaussian {
    float a, b;
};
constexpr std::array kAchromatic = {Gaussian{1, 0.0047f}};
constexpr std::array kRedGreen = {Gaussian{1, 0.0053f}};
constexpr std::array kBlueYellow = {Gaussian{34.1f, 0.04f}, Gaussian{13.5f, 0.025f}};
constexpr float kWidestB = 0.04f;

Plane sensitivityFiltered(const Plane& channel, std::span<const Gaussian> sum, float perDegree) {
    const int radius = int(std::ceil(3 * std::sqrt(kWidestB / (2 * kPi * kPi)) * perDegree));
    Plane result(channel.width, channel.height);
    double total = 0;
    for (const Gaussian& term : sum) {
        const Kernel kernel = gaussian(perDegree * std::sqrt(term.b / 2) / kPi, radius);
        double kernelSum = 0;
        for (double weight : kernel) kernelSum += weight;
        const double weight = term.a * std::sqrt(kPi / term.b);
        total += weight * kernelSum * kernelSum;
        const Plane part = filtered(channel, kernel, kernel);
        for (size_t i = 0; i < part.values.size(); ++i) result.values[i] += weight * part.values[i];
    }
    for (double& value : result.values) value /= total;
    return result;
}

using Opponent = std::array<Plane, 3>;

Opponent opponentPlanes(std::span<const vec3> rgb, uint32_t width, uint32_t height) {
    Opponent planes{Plane(width, height), Plane(width, height), Plane(width, height)};
    for (size_t i = 0; i < rgb.size(); ++i) {
        const vec3 opponent = opponentFromRgb(rgb[i]);
        for (int c = 0; c < 3; ++c) planes[size_t(c)].values[i] = opponent[c];
    }
    return planes;
}

/// What the eye sees of the picture, in Hunt-adjusted L*a*b*.
std::vector<vec3> perceived(const Opponent& opponent, float perDegree) {
    const Plane a = sensitivityFiltered(opponent[0], kAchromatic, perDegree);
    const Plane rg = sensitivityFiltered(opponent[1], kRedGreen, perDegree);
    const Plane by = sensitivityFiltered(opponent[2], kBlueYellow, perDegree);
    std::vector<vec3> lab(a.values.size());
    for (size_t i = 0; i < lab.size(); ++i) {
        const vec3 rgb = rgbFromOpponent({a.values[i], rg.values[i], by.values[i]});
        lab[i] = huntAdjusted(labFromRgb(glm::clamp(rgb, 0.0f, 1.0f)));
    }
    return lab;
}

/// Compresses large distances: the first 40 % of the range take 95 % of the result (equation 10).
float redistributed(float distance) {
    constexpr float kExponent = 0.7f;
    constexpr float kKnee = 0.4f;
    constexpr float kKneeValue = 0.95f;
    static const float largest = std::pow(
        hyabDistance(huntAdjusted(labFromRgb({0, 1, 0})), huntAdjusted(labFromRgb({0, 0, 1}))),
        kExponent);
    const float error = std::pow(distance, kExponent);
    const float knee = kKnee * largest;
    if (error < knee) return kKneeValue / knee * error;
    return kKneeValue + (error - knee) / (largest - knee) * (1 - kKneeValue);
}

// ---- feature difference (section 4.3)
// ----------------------------------------------------------------------------

/// Positive weights sum to 1 and negative ones to -1.
Kernel balanced(Kernel kernel) {
    double positive = 0;
    double negative = 0;
    for (double weight : kernel) (weight > 0 ? positive : negative) += std::abs(weight);
    for (double& weight : kernel) weight /= weight > 0 ? positive : negative;
    return kernel;
}

struct FeatureKernels {
    Kernel smooth, edge, point;

    explicit FeatureKernels(float perDegree) {
        constexpr double kWidth = 0.082f;  // degrees, of the edge that is looked for
        const double sigma = 0.5f * kWidth * perDegree;
        const int radius = int(std::ceil(3 * sigma));
        smooth = gaussian(sigma, radius);
        edge = point = smooth;
        for (int x = -radius; x <= radius; ++x) {
            edge[size_t(x + radius)] *= -double(x);
            point[size_t(x + radius)] *= double(x * x) / (sigma * sigma) - 1;
        }
        smooth = normalized(smooth);
        edge = balanced(edge);
        point = balanced(point);
    }
};

/// Length of the gradient (edge kernel) or of the second derivatives (point kernel).
Plane magnitude(const Plane& y, const Kernel& derivative, const Kernel& smooth) {
    Plane dx = filtered(y, derivative, smooth);
    const Plane dy = filtered(y, smooth, derivative);
    for (size_t i = 0; i < dx.values.size(); ++i)
        dx.values[i] = std::hypot(dx.values[i], dy.values[i]);
    return dx;
}

Plane luminance(const Plane& achromatic) {
    Plane y = achromatic;
    for (double& value : y.values) value = (value + 16) / 116;
    return y;
}

Plane featureErrors(const Plane& achromaticA, const Plane& achromaticB, float perDegree) {
    const FeatureKernels kernels(perDegree);
    const Plane a = luminance(achromaticA);
    const Plane b = luminance(achromaticB);
    Plane errors = magnitude(a, kernels.edge, kernels.smooth);
    const Plane edgesB = magnitude(b, kernels.edge, kernels.smooth);
    const Plane pointsA = magnitude(a, kernels.point, kernels.smooth);
    const Plane pointsB = magnitude(b, kernels.point, kernels.smooth);
    for (size_t i = 0; i < errors.values.size(); ++i) {
        const double difference = std::max(std::abs(errors.values[i] - edgesB.values[i]),
                                           std::abs(pointsA.values[i] - pointsB.values[i]));
        errors.values[i] = std::sqrt(difference / std::sqrt(2.0));
    }
    return errors;
}

}  // namespace

Plane flipErrors(std::span<const vec3> reference, std::span<const vec3> test, uint32_t width,
                 uint32_t height, float pixelsPerDegree) {
    const Opponent a = opponentPlanes(reference, width, height);
    const Opponent b = opponentPlanes(test, width, height);
    const std::vector<vec3> labA = perceived(a, pixelsPerDegree);
    const std::vector<vec3> labB = perceived(b, pixelsPerDegree);
    Plane errors = featureErrors(a[0], b[0], pixelsPerDegree);
    for (size_t i = 0; i < errors.values.size(); ++i) {
        const float color = redistributed(hyabDistance(labA[i], labB[i]));
        errors.values[i] = std::pow(color, 1 - errors.values[i]);
    }
    return errors;
}

}  // namespace rushlight

#include "renderer/lighting/environment/atmosphere.h"

#include "renderer/lighting/environment/sampling.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

// At 611, 549 and 464 nm, the dominant wavelengths of Rec.709's primaries. (680, 550 and 440 nm,
// which are often taken, miss ozone's band at 600 nm and make dusk purple.)
const vec3 kRayleigh(8.90e-3f, 13.66e-3f, 26.77e-3f);
const vec3 kOzone(2.28e-3f, 1.86e-3f, 0.226e-3f);
constexpr float kMieScattering = 3.996e-3f;
constexpr float kMieAbsorption = 4.40e-3f;
constexpr float kRayleighHeight = 8;
constexpr float kMieHeight = 1.2f;
constexpr float kOzoneMiddle = 25, kOzoneHalfWidth = 15;
constexpr float kMieAsymmetry = 0.8f;
constexpr float kThickness = Atmosphere::kTopRadius - Atmosphere::kGroundRadius;
constexpr uint32_t kTransmittanceSteps = 40;
constexpr uint32_t kMarchSteps = 40;
constexpr uint32_t kScatteringSide = 32;
constexpr uint32_t kScatteringDirections = 64;

/// A point at a height over the pole of a planet at the origin.
vec3 placeAt(float height) { return {0, Atmosphere::kGroundRadius + height, 0}; }

/// Distance along a ray to a sphere about the origin: the farther one from inside, else the nearer;
/// < 0: never.
float distanceToSphere(const vec3& from, const vec3& direction, float radius) {
    const float b = glm::dot(from, direction);
    // In double: the radii are thousands of times the heights that matter.
    const double c = glm::dot(glm::dvec3(from), glm::dvec3(from)) - double(radius) * radius;
    const double discriminant = double(b) * b - c;
    if (discriminant < 0) return -1;
    const float root = float(std::sqrt(discriminant));
    const float nearer = -b - root, farther = -b + root;
    return nearer > 0 ? nearer : farther;
}

float rayleighPhase(float cosine) { return 3 / (16 * kPi) * (1 + cosine * cosine); }

/// Cornette and Shanks 1992, "Physically reasonable analytic expression for the single-scattering
/// phase function".
float miePhase(float cosine) {
    constexpr float g = kMieAsymmetry;
    const float base = std::max(1 + g * g - 2 * g * cosine, 1e-6f);
    return 3 / (8 * kPi) * ((1 - g * g) * (1 + cosine * cosine)) /
           ((2 + g * g) * base * std::sqrt(base));
}

vec3 exponential(const vec3& v) { return {std::exp(v.x), std::exp(v.y), std::exp(v.z)}; }

/// Where a ray leaves the air: into the ground or into space.
struct Path {
    float length = 0;
    bool hitsGround = false;
};

Path pathThroughAir(const vec3& from, const vec3& direction) {
    const float radius = glm::length(from);
    const bool down = glm::dot(from, direction) < 0;
    const float ground = down ? distanceToSphere(from, direction, Atmosphere::kGroundRadius) : -1;
    if (ground > 0) return {ground, true};
    if (down && radius <= Atmosphere::kGroundRadius) return {0, true};
    return {std::max(distanceToSphere(from, direction, Atmosphere::kTopRadius), 0.0f), false};
}

}  // namespace

vec3 Atmosphere::Table::sample(float u, float v) const {
    const float x = std::clamp(u, 0.0f, 1.0f) * float(width - 1);
    const float y = std::clamp(v, 0.0f, 1.0f) * float(height - 1);
    const uint32_t x0 = std::min(uint32_t(x), width - 2), y0 = std::min(uint32_t(y), height - 2);
    const vec3* row = &texels[size_t(y0) * width + x0];
    const float fx = x - float(x0), fy = y - float(y0);
    return glm::mix(glm::mix(row[0], row[1], fx), glm::mix(row[width], row[width + 1], fx), fy);
}

Atmosphere::Atmosphere(float haze, const vec3& groundAlbedo, JobSystem& jobs)
    : haze_(haze), groundAlbedo_(groundAlbedo) {
    makeTransmittance(jobs);
    makeMultipleScattering(jobs);
}

Medium Atmosphere::mediumAt(float height) const {
    const float molecules = std::exp(-height / kRayleighHeight);
    const float haze = haze_ * std::exp(-height / kMieHeight);
    const float ozone = std::max(0.0f, 1 - std::abs(height - kOzoneMiddle) / kOzoneHalfWidth);
    Medium medium;
    medium.rayleigh = kRayleigh * molecules;
    medium.mie = kMieScattering * haze;
    medium.extinction = medium.rayleigh + vec3((kMieScattering + kMieAbsorption) * haze) +
                        kOzone * ozone;
    return medium;
}

// The table's rows are square roots of heights, its columns run from the horizon to the zenith by
// square roots of cosines above the horizon of each height: where the light changes fastest there
// are the most texels.
void Atmosphere::makeTransmittance(JobSystem& jobs) {
    transmittance_ = {128, 64, {}};
    transmittance_.texels.resize(size_t(transmittance_.width) * transmittance_.height);
    jobs.forRanges(transmittance_.height, 4, [&](uint32_t begin, uint32_t end) {
        for (uint32_t y = begin; y < end; ++y) {
            const float v = float(y) / float(transmittance_.height - 1);
            const float height = v * v * kThickness;
            const float radius = kGroundRadius + height;
            const float horizon = -std::sqrt(
                std::max(0.0f, 1 - kGroundRadius / radius * (kGroundRadius / radius)));
            for (uint32_t x = 0; x < transmittance_.width; ++x) {
                const float u = float(x) / float(transmittance_.width - 1);
                const float cosine = horizon + (1 - horizon) * u * u;
                const vec3 direction(std::sqrt(std::max(0.0f, 1 - cosine * cosine)), cosine, 0);
                const vec3 from = placeAt(height);
                const float length = std::max(distanceToSphere(from, direction, kTopRadius), 0.0f);
                vec3 depth(0);
                for (uint32_t i = 0; i < kTransmittanceSteps; ++i) {
                    // Steps grow with the square of their number: the air is thickest near the
                    // start.
                    const float a = float(i) / kTransmittanceSteps;
                    const float b = float(i + 1) / kTransmittanceSteps;
                    const float t = (a * a + b * b) * 0.5f * length;
                    const float at = glm::length(from + direction * t) - kGroundRadius;
                    depth += mediumAt(std::max(at, 0.0f)).extinction * ((b * b - a * a) * length);
                }
                transmittance_.texels[size_t(y) * transmittance_.width + x] = exponential(-depth);
            }
        }
    });
}

vec3 Atmosphere::transmittance(float height, float cosZenith) const {
    const float radius = kGroundRadius + height;
    const float horizon = -std::sqrt(
        std::max(0.0f, 1 - kGroundRadius / radius * (kGroundRadius / radius)));
    if (cosZenith < horizon) return vec3(0);
    return transmittance_.sample(std::sqrt((cosZenith - horizon) / (1 - horizon)),
                                 std::sqrt(std::clamp(height / kThickness, 0.0f, 1.0f)));
}

vec3 Atmosphere::multipleScattering(float height, float cosSun) const {
    return multiple_.sample(cosSun * 0.5f + 0.5f,
                            std::sqrt(std::clamp(height / kThickness, 0.0f, 1.0f)));
}

// Hillaire 2020, section 5.5: what arrives at a point after two scatterings, L2, and the share f of
// light, sent out evenly around it, that comes back; all further orders are L2 (1 + f + f² + ...) =
// L2 / (1 - f).
void Atmosphere::makeMultipleScattering(JobSystem& jobs) {
    Table table{kScatteringSide, kScatteringSide, {}};
    table.texels.resize(size_t(kScatteringSide) * kScatteringSide);
    jobs.forRanges(kScatteringSide, 1, [&](uint32_t begin, uint32_t end) {
        for (uint32_t y = begin; y < end; ++y)
            for (uint32_t x = 0; x < kScatteringSide; ++x) {
                const float v = float(y) / (kScatteringSide - 1);
                const float height = std::min(v * v * kThickness, kThickness - 0.01f);
                const float cosine = float(x) / (kScatteringSide - 1) * 2 - 1;
                const vec3 sun(std::sqrt(std::max(0.0f, 1 - cosine * cosine)), cosine, 0);
                vec3 second(0), back(0);
                for (uint32_t i = 0; i < kScatteringDirections; ++i) {
                    const vec2 u = hammersley(i, kScatteringDirections);
                    const float z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0f, 1 - z * z));
                    const vec3 direction(r * std::cos(2 * kPi * u.y), z,
                                         r * std::sin(2 * kPi * u.y));
                    vec3 unit(0);
                    second += march(height, direction, sun, true, &unit);
                    back += unit;
                }
                const float share = 1.0f / kScatteringDirections;
                table.texels[size_t(y) * kScatteringSide + x] = second * share /
                                                                (vec3(1) - glm::min(back * share,
                                                                                    vec3(0.999f)));
            }
    });
    multiple_ = std::move(table);
}

vec3 Atmosphere::radiance(float height, const vec3& direction, const vec3& sun) const {
    return march(height, direction, sun, false, nullptr);
}

// Single scattering of the sun along a ray, plus the table of further orders unless
// `firstOrderAlone`, in which case light scatters evenly all around. `unitScattering`: what a
// medium of unit radiance all around would scatter towards the start.
vec3 Atmosphere::march(float height, const vec3& direction, const vec3& sun, bool firstOrderAlone,
                       vec3* unitScattering) const {
    const vec3 from = placeAt(height);
    const Path path = pathThroughAir(from, direction);
    const float cosine = glm::dot(direction, sun);
    const float rayleigh = firstOrderAlone ? 1 / (4 * kPi) : rayleighPhase(cosine);
    const float mie = firstOrderAlone ? 1 / (4 * kPi) : miePhase(cosine);
    vec3 sum(0), through(1), unit(0);
    for (uint32_t i = 0; i < kMarchSteps; ++i) {
        const float a = float(i) / kMarchSteps, b = float(i + 1) / kMarchSteps;
        const float step = (b * b - a * a) * path.length;
        const vec3 at = from + direction * ((a * a + b * b) * 0.5f * path.length);
        const float radius = glm::length(at);
        const float h = std::max(radius - kGroundRadius, 0.0f);
        const float cosSun = glm::dot(at, sun) / radius;
        const Medium medium = mediumAt(h);
        const vec3 lit = transmittance(h, cosSun);
        vec3 source = lit * (medium.rayleigh * rayleigh + vec3(medium.mie * mie));
        const vec3 scattering = medium.rayleigh + vec3(medium.mie);
        if (!firstOrderAlone) source += multipleScattering(h, cosSun) * scattering;
        // The step's integral in closed form: Hillaire 2015, "Physically Based and Unified
        // Volumetric Rendering".
        const vec3 absorbed = exponential(-medium.extinction * step);
        const vec3 share = (vec3(1) - absorbed) / glm::max(medium.extinction, vec3(1e-9f));
        sum += through * source * share;
        unit += through * scattering * share;
        through *= absorbed;
    }
    if (path.hitsGround) {
        const vec3 at = from + direction * path.length;
        const vec3 normal = glm::normalize(at);
        const float cosSun = glm::dot(normal, sun);
        vec3 irradiance = transmittance(0, cosSun) * std::max(cosSun, 0.0f);
        // The sky's own share of the ground's light: about the even light of many scatterings from
        // a half sphere.
        if (!firstOrderAlone) irradiance += multipleScattering(0, cosSun) * kPi;
        sum += through * irradiance * groundAlbedo_ / kPi;
    }
    if (unitScattering) *unitScattering = unit;
    return sum;
}

}  // namespace rushlight

#include "renderer/lighting/ltc_fit.h"

#include "interop/ltc.h"
#include "renderer/lighting/environment/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace rushlight {
namespace {

constexpr float kLeastAlpha = 5e-4f;  // rows below interop::kMinRoughness serve interpolation alone
constexpr float kLeastCosine = 0.01f;
constexpr uint32_t kSamples = 576;
constexpr double kPower = 1.5;
/// Of the lobes' own difference beside that of whole lights, times alpha: without it lights that
/// are narrower than the caps suffer.
constexpr float kShapeWeight = 1;
constexpr float kSharpAlpha = 0.01f;  // what is sharper is a point to whole lights

/// GGX seen from one side: the view in the x-z plane.
struct Lobe {
    vec3 view;
    float alpha, alpha2, rootV;
    float albedo = 0;
    vec3 mean{0};

    Lobe(float nDotV, float roughness) {
        const float cosine = std::clamp(nDotV, kLeastCosine, 1.0f);
        view = {std::sqrt(1 - cosine * cosine), 0, cosine};
        alpha = std::max(roughness * roughness, kLeastAlpha);
        alpha2 = alpha * alpha;
        rootV = interop::smithRoot(cosine, alpha2);
    }
    /// Times the cosine; and the density by which sampleLight samples it.
    float value(const vec3& light, float& density) const {
        density = 0;
        if (light.z <= 0) return 0;
        const vec3 half = glm::normalize(view + light);
        const float d = interop::distributionGgx(half.z, alpha2);
        const float g1 = 2 * view.z / (view.z + rootV);
        density = g1 * d / (4 * view.z);
        return d * light.z *
               interop::visibilitySmith(view.z, light.z, rootV,
                                        interop::smithRoot(light.z, alpha2));
    }
    vec3 sampleLight(const vec2& u) const {
        const vec3 half = sampleVisibleNormal(view, alpha, u);
        return 2 * glm::dot(view, half) * half - view;
    }
    void measure() {
        constexpr uint32_t kCount = 4096;
        for (uint32_t i = 0; i < kCount; ++i) {
            const vec3 light = sampleLight(hammersley(i, kCount));
            float density;
            const float weight = value(light, density);
            if (!(weight > 0)) continue;
            albedo += weight / density / float(kCount);
            mean += light * (weight / density);
        }
        mean = glm::normalize(vec3(mean.x, 0, mean.z));
    }
};

/// M = [x y z] [a 0 c; 0 b 0; 0 0 1]: the lobe's own axes, turned in the view's plane by the
/// fourth, times scales and a shear.
using Parameters = std::array<float, 4>;

mat3 matrixOf(const Lobe& lobe, const Parameters& p) {
    const float angle = std::atan2(lobe.mean.x, lobe.mean.z) + p[3];
    const vec3 z(std::sin(angle), 0, std::cos(angle)), x(z.z, 0, -z.x), y(0, 1, 0);
    const float a = std::max(std::abs(p[0]), 1e-5f), b = std::max(std::abs(p[1]), 1e-5f);
    return mat3(x * a, y * b, x * p[2] + z);
}

float transformedCosine(const mat3& inverse, float determinant, const vec3& light) {
    const vec3 before = inverse * light;
    const float length2 = glm::dot(before, before), length = std::sqrt(length2);
    const float cosine = std::max(before.z / length, 0.0f);
    return cosine * interop::kInversePi * determinant / (length2 * length);
}

/// As interop::applyLtc takes them; those that mix y with the others are zero.
vec4 elementsOf(const mat3& inverse) {
    return vec4(inverse[0][0], inverse[2][0], inverse[0][2], inverse[2][2]) / inverse[1][1];
}

float errorOf(const Lobe& lobe, const Parameters& p) {
    const mat3 m = matrixOf(lobe, p), inverse = glm::inverse(m);
    const float determinant = std::abs(glm::determinant(inverse));
    double sum = 0;
    const auto add = [&](const vec3& light) {
        float density;
        const float truth = lobe.value(light, density) / lobe.albedo;
        const float fitted = transformedCosine(inverse, determinant, light);
        const float difference = std::abs(truth - fitted);
        if (density + fitted > 0) sum += std::pow(double(difference), kPower) / (density + fitted);
    };
    for (uint32_t i = 0; i < kSamples; ++i) {
        const vec2 u = hammersley(i, kSamples);
        add(lobe.sampleLight(u));
        const float ring = std::sqrt(u.x), phi = 2 * kPi * u.y;
        add(glm::normalize(m *
                           vec3(ring * std::cos(phi), ring * std::sin(phi), std::sqrt(1 - u.x))));
    }
    return float(sum);
}

/// What whole lights get of a lobe: its integrals over soft-edged caps that cover the hemisphere,
/// in three sizes.
class CapLights {
public:
    CapLights() {
        constexpr uint32_t kDirections = 128;  // over all; the lobes are symmetric in y
        for (uint32_t i = 0; i < kDirections; ++i) {
            const vec2 u = hammersley(i, kDirections);
            const float z = u.x, ring = std::sqrt(1 - z * z), phi = kPi * u.y;
            for (const float radius : {0.15f, 0.3f, 0.6f})
                caps_.push_back(
                    {vec3(ring * std::cos(phi), ring * std::sin(phi), z), std::cos(radius)});
        }
    }
    size_t count() const { return caps_.size(); }
    /// Adds one direction's weight to each cap's sum; to both sides of the symmetry at once.
    void add(const vec3& light, float weight, std::span<float> sums) const {
        if (!(light.z > 0)) return;
        const vec3 l(light.x, std::abs(light.y), light.z);
        for (size_t i = 0; i < caps_.size(); ++i) {
            const Cap& cap = caps_[i];
            const float planar = l.x * cap.axis.x + l.z * cap.axis.z, across = l.y * cap.axis.y;
            sums[i] += 0.5f * weight *
                       (cover(planar + across - cap.cosine) + cover(planar - across - cap.cosine));
        }
    }

private:
    struct Cap {
        vec3 axis;
        float cosine;
    };
    static float cover(float inside) {
        const float t = std::clamp(0.5f + inside * 8, 0.0f, 1.0f);
        return t * t * (3 - 2 * t);
    }
    std::vector<Cap> caps_;
};

/// The differences of two lobes' integrals: the eighth power, as the worst light counts, on the
/// scale of the fourth.
class CapError {
public:
    explicit CapError(const Lobe& lobe) : truth_(lights().count()), fitted_(lights().count()) {
        constexpr uint32_t kCount = 2048;
        for (uint32_t i = 0; i < kCount; ++i) {
            const vec3 light = lobe.sampleLight(hammersley(i, kCount));
            float density;
            const float weight = lobe.value(light, density);
            if (weight > 0)
                lights().add(light, weight / density / (float(kCount) * lobe.albedo), truth_);
        }
    }
    float of(const mat3& m) {
        constexpr uint32_t kCount = 512;
        std::ranges::fill(fitted_, 0.0f);
        for (uint32_t i = 0; i < kCount; ++i) {
            const vec2 u = hammersley(i, kCount);
            const float ring = std::sqrt(u.x), phi = 2 * kPi * u.y;
            lights().add(glm::normalize(m * vec3(ring * std::cos(phi), ring * std::sin(phi),
                                                 std::sqrt(1 - u.x))),
                         1 / float(kCount), fitted_);
        }
        double sum = 0;
        for (size_t i = 0; i < truth_.size(); ++i) {
            const double difference = double(truth_[i] - fitted_[i]),
                         square = difference * difference;
            sum += square * square * square * square;
        }
        return float(std::sqrt(sum) * 1e6);
    }

private:
    static const CapLights& lights() {
        static const CapLights made;
        return made;
    }
    std::vector<float> truth_, fitted_;
};

// Nelder and Mead, "A Simplex Method for Function Minimization", 1965, over the first `dimensions`
// parameters.
template <class Function>
Parameters minimize(Parameters start, int dimensions, float spread, Function&& f) {
    struct Point {
        Parameters p;
        float error;
    };
    std::array<Point, 5> simplex;
    const auto at = [&](const Parameters& p) { return Point{p, f(p)}; };
    for (int i = 0; i <= dimensions; ++i) {
        Parameters p = start;
        if (i > 0)
            p[size_t(i - 1)] += i >= 3 ? spread * std::min(start[1], 0.3f)
                                       : spread * std::max(p[size_t(i - 1)], 0.01f);
        simplex[size_t(i)] = at(p);
    }
    const auto along = [&](const Parameters& from, const Parameters& to, float t) {
        Parameters p = from;
        for (size_t i = 0; i < p.size(); ++i) p[i] += (to[i] - from[i]) * t;
        return p;
    };
    for (int step = 0; step < 120; ++step) {
        for (int i = 1; i <= dimensions; ++i)
            for (int k = i; k > 0 && simplex[size_t(k)].error < simplex[size_t(k - 1)].error; --k)
                std::swap(simplex[size_t(k)], simplex[size_t(k - 1)]);
        Parameters middle{};
        for (int i = 0; i < dimensions; ++i)
            for (size_t k = 0; k < 4; ++k) middle[k] += simplex[size_t(i)].p[k] / float(dimensions);
        Point& worst = simplex[size_t(dimensions)];
        const Point reflected = at(along(worst.p, middle, 2));
        if (reflected.error < simplex[0].error) {
            const Point expanded = at(along(worst.p, middle, 3));
            worst = expanded.error < reflected.error ? expanded : reflected;
        } else if (reflected.error < simplex[size_t(dimensions - 1)].error) {
            worst = reflected;
        } else {
            const Point contracted = at(
                along(worst.p, middle, reflected.error < worst.error ? 1.5f : 0.5f));
            if (contracted.error < std::min(worst.error, reflected.error)) {
                worst = contracted;
            } else {
                for (int i = 1; i <= dimensions; ++i)
                    simplex[size_t(i)] = at(along(simplex[0].p, simplex[size_t(i)].p, 0.5f));
            }
        }
    }
    size_t best = 0;
    for (size_t i = 1; i <= size_t(dimensions); ++i)
        if (simplex[i].error < simplex[best].error) best = i;
    return simplex[best].p;
}

}  // namespace

vec4 fitLtc(float nDotV, float roughness) {
    Lobe lobe(nDotV, roughness);
    lobe.measure();
    const bool isotropic = lobe.view.x < 1e-3f;
    if (isotropic) lobe.mean = {0, 0, 1};
    const auto error = [&](const Parameters& p) {
        return errorOf(lobe, isotropic ? Parameters{p[0], p[0], 0, 0} : p);
    };
    // Seen at an angle, a lobe is narrower along the view's plane.
    const float start = std::max(lobe.alpha, 1e-3f);
    Parameters p{start * std::max(lobe.view.z, 0.2f), start, 0, 0};
    if (isotropic) {
        p = minimize({start, start, 0, 0}, 1, 0.3f, error);
        p[1] = p[0];
    } else {
        p = minimize(p, 3, 0.3f, error);
        p = minimize(p, 4, 0.1f, error);
        if (lobe.alpha > kSharpAlpha) {
            CapError caps(lobe);
            p = minimize(p, 4, 0.1f, [&](const Parameters& q) {
                return caps.of(matrixOf(lobe, q)) + kShapeWeight * lobe.alpha * error(q);
            });
        }
    }
    return elementsOf(glm::inverse(matrixOf(lobe, p)));
}

std::vector<vec4> fitLtcTable(JobSystem& jobs, uint32_t size) {
    std::vector<vec4> table(size_t(size) * size);
    jobs.forRanges(size * size, 8, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) {
            const float column = float(i % size) / float(size - 1);
            table[i] = fitLtc(1 - column * column, float(i / size) / float(size - 1));
        }
    });
    return table;
}

float specularLobe(float nDotV, float roughness, const vec3& light) {
    float density;
    return Lobe(nDotV, roughness).value(light, density);
}

}  // namespace rushlight

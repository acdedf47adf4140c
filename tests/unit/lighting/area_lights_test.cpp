// Area lights by linearly transformed cosines against sums over their surfaces with the BRDF
// itself.
#include "renderer/lighting/brdf_table.h"
#include "renderer/lighting/environment/sampling.h"
#include "renderer/lighting/ltc_fit.h"
#include "renderer/lighting/ltc_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace rushlight {
namespace {

using namespace interop;

constexpr uint32_t kSamples = 1 << 18;  // a sharp lobe sees few of them

/// A point of a light's surface, relative to the lit point, its unit normal, and the area it stands
/// for.
struct SurfacePoint {
    vec3 position, normal;
    float area;
};
using Surface = std::function<SurfacePoint(const vec2&)>;

struct AreaCase {
    const char* name;
    LightOutline outline;
    Surface surface;
    bool closed;  ///< shines outwards alone
};

AreaCase rectangle(const char* name, const vec3& center, const vec3& x, const vec3& y) {
    const vec3 across = glm::cross(x, y);
    return {name, rectangleOutline(center, x, y),
            [=](const vec2& u) {
                return SurfacePoint{center + x * (2 * u.x - 1) + y * (2 * u.y - 1),
                                    glm::normalize(across), 4 * glm::length(across)};
            },
            false};
}

AreaCase disk(const char* name, const vec3& center, const vec3& x, const vec3& y) {
    const vec3 across = glm::cross(x, y);
    return {name, diskOutline(center, x, y),
            [=](const vec2& u) {
                const float r = std::sqrt(u.x), phi = 2 * kPi * u.y;
                return SurfacePoint{center + x * (r * std::cos(phi)) + y * (r * std::sin(phi)),
                                    glm::normalize(across), kPi * glm::length(across)};
            },
            false};
}

AreaCase sphere(const char* name, const vec3& center, float radius) {
    return {name, sphereOutline(center, radius),
            [=](const vec2& u) {
                const float z = 1 - 2 * u.x, r = std::sqrt(1 - z * z), phi = 2 * kPi * u.y;
                const vec3 n(r * std::cos(phi), r * std::sin(phi), z);
                return SurfacePoint{center + n * radius, n, 4 * kPi * radius * radius};
            },
            true};
}

AreaCase tube(const char* name, const vec3& center, const vec3& half, float radius) {
    const float length = glm::length(half);
    const vec3 axis = half / length, x = perpendicularTo(axis), y = glm::cross(axis, x);
    const float side = 4 * kPi * radius * length, caps = 2 * kPi * radius * radius;
    return {name, tubeOutline(center, half, radius),
            [=](const vec2& u) {
                const float phi = 2 * kPi * u.y;
                const vec3 out = x * std::cos(phi) + y * std::sin(phi);
                const float t = u.x * (side + caps);
                if (t < side)
                    return SurfacePoint{center + half * (2 * t / side - 1) + out * radius, out,
                                        side + caps};
                const float place = (t - side) / caps * 2, sign = place < 1 ? 1.0f : -1.0f;
                const float r = std::sqrt(place < 1 ? place : place - 1) * radius;
                return SurfacePoint{center + half * sign + out * r, axis * sign, side + caps};
            },
            true};
}

std::vector<AreaCase> cases() {
    const vec3 up(0, 0, 1);
    return {
        rectangle("rectangle above", {-0.5f, 0.3f, 1.5f}, {1, 0, 0}, {0, 0.6f, 0}),
        rectangle("upright rectangle through the horizon", {-2, 0.5f, 0.2f}, {0, 1.2f, 0},
                  {0, 0, 0.8f}),
        rectangle("tilted rectangle", {-1, -1, 1}, {0.7f, 0, 0.7f}, {0, 0.8f, 0.1f}),
        disk("disk above", {-0.8f, 0, 1.2f}, {0.6f, 0, 0.2f}, {0, 0.6f, 0}),
        disk("disk through the horizon", {-1.5f, 0.4f, 0.1f}, {0, 0.7f, 0}, {0.1f, 0, 0.7f}),
        sphere("sphere above", {-1, 0.2f, 1.5f}, 0.5f),
        sphere("sphere through the horizon", {-1.4f, 0, 0.2f}, 0.6f),
        tube("tube across", {-1, 0, 1}, {0, 1, 0}, 0.1f),
        tube("thick tube that shows an end", {-1.2f, 0.5f, 0.8f}, {0.3f, 0.6f, 0.1f}, 0.3f),
        tube("tube through the horizon", {-1, 0, 0.2f}, {0.2f, 0, 0.8f}, 0.15f),
    };
}

struct Sums {
    double diffuse = 0, specular = 0;  ///< of the form factors' kind: 1 is light from everywhere
};

/// Sums radiance 1 over the surface: the definition of what outlineFormFactors gives.
Sums sumSurface(const AreaCase& c, float nDotV, float roughness) {
    Sums sums;
    const vec2 table = integrateBrdf(nDotV, roughness, 4096);
    for (uint32_t i = 0; i < kSamples; ++i) {
        const SurfacePoint p = c.surface(hammersley(i, kSamples));
        const float distance2 = glm::dot(p.position, p.position);
        const vec3 l = p.position / std::sqrt(distance2);
        const float facing = -glm::dot(l, p.normal);
        if (l.z <= 0 || (c.closed && facing <= 0)) continue;
        const double solidAngle = std::abs(facing) * p.area / distance2 / kSamples;
        sums.diffuse += solidAngle * double(l.z * kInversePi);
        sums.specular += solidAngle * double(specularLobe(nDotV, roughness, l)) /
                         double(table.x + table.y);
    }
    return sums;
}

vec2 byLtc(const AreaCase& c, float nDotV, float roughness) {
    return outlineFormFactors(c.outline, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                              lookUpLtc(nDotV, roughness));
}

TEST(AreaLights, DiffuseFormFactorsEqualTheSumOverTheSurface) {
    for (const AreaCase& c : cases()) {
        const double expected = sumSurface(c, 0.7f, 0.5f).diffuse;
        EXPECT_NEAR(byLtc(c, 0.7f, 0.5f).x / expected, 1, 0.01) << c.name;
    }
}

TEST(AreaLights, SolidAnglesAreThoseOfTheSurface) {
    for (const AreaCase& c : cases()) {
        double sum = 0;
        for (uint32_t i = 0; i < kSamples; ++i) {
            const SurfacePoint p = c.surface(hammersley(i, kSamples));
            const float distance2 = glm::dot(p.position, p.position);
            const float facing = -glm::dot(p.position, p.normal) / std::sqrt(distance2);
            if (c.closed && facing <= 0) continue;
            sum += double(std::abs(facing) * p.area / distance2 / kSamples);
        }
        EXPECT_NEAR(double(outlineSolidAngle(c.outline)) / sum, 1, 0.01) << c.name;
    }
    const vec3 at(1, -2, 2);
    EXPECT_NEAR(ballSolidAngle(glm::dot(at, at), 0.9f) / outlineSolidAngle(sphereOutline(at, 0.9f)),
                1, 2e-3f);
    EXPECT_NEAR(ballSolidAngle(0.1f, 1), 2 * kPi, 1e-5f) << "within it there is half of all around";
}

TEST(AreaLights, AWholeHemisphereIsOne) {
    const AreaCase c = rectangle("", {0, 0, 0.01f}, {20, 0, 0}, {0, 20, 0});
    for (const float roughness : {0.1f, 0.5f, 1.0f}) {
        const vec2 f = byLtc(c, 0.6f, roughness);
        EXPECT_NEAR(f.x, 1, 1e-3f);
        EXPECT_NEAR(f.y, 1, 0.03f) << roughness;
    }
}

// Specular and diffuse light together, as a white dielectric reflects it, and the specular lobe
// alone as a share of all its light (a metal).
TEST(AreaLights, SpecularFormFactorsFollowTheSumOverTheSurface) {
    double sum = 0, worst = 0, worstDielectric = 0;
    uint32_t count = 0;
    for (const float roughness : {0.1f, 0.2f, 0.35f, 0.5f, 0.75f, 1.0f})
        for (const float nDotV : {0.25f, 0.5f, 0.7f, 0.95f})
            for (const AreaCase& c : cases()) {
                const Sums truth = sumSurface(c, nDotV, roughness);
                const vec2 f = byLtc(c, nDotV, roughness);
                const double error = std::abs(double(f.y) - truth.specular);
                const double reflected = truth.diffuse + 0.04 * truth.specular;
                const double dielectric = std::abs(double(f.x) + 0.04 * double(f.y) - reflected) /
                                          reflected;
                EXPECT_LT(error, 0.03) << c.name << " " << roughness << " " << nDotV;
                EXPECT_LT(dielectric, 0.03) << c.name << " " << roughness << " " << nDotV;
                sum += error;
                worst = std::max(worst, error);
                worstDielectric = std::max(worstDielectric, dielectric);
                ++count;
            }
    EXPECT_LT(sum / count, 0.006);
    RecordProperty("worst", std::to_string(worst));
    RecordProperty("worstDielectric", std::to_string(worstDielectric));
}

// The table that is checked in is what the tool makes of today's BRDF.
TEST(AreaLights, TheTableIsThatOfTheBrdf) {
    constexpr uint32_t kSize = RL_LTC_TABLE_SIZE;
    for (const uint32_t i : {5 * kSize + 3, 12 * kSize + 20, 22 * kSize + 9, 31 * kSize + 15}) {
        const float column = float(i % kSize) / (kSize - 1);
        const vec4 fitted = fitLtc(1 - column * column, float(i / kSize) / (kSize - 1));
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(kLtcTable[i][c], fitted[c], 2e-3f) << i << " " << c;
    }
}

}  // namespace
}  // namespace rushlight

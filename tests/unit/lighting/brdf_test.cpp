// The shared BRDF, compiled as C++.

#include "interop/brdf.h"
#include "renderer/lighting/brdf_table.h"
#include "renderer/lighting/environment/sampling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rushlight {
namespace {

using namespace interop;

/// Without compensation: the single-scattering lobe of a table that loses nothing.
constexpr vec2 kNoLoss(1, 0);

vec3 viewAt(float nDotV) { return {std::sqrt(1 - nDotV * nDotV), 0, nDotV}; }

/// Light reflected towards `view` under white light of radiance 1: half the samples by visible
/// normals, half by cosine, weighted by the balance heuristic, so that neither lobe is
/// undersampled.
vec3 furnace(const ShadingPoint& p, float roughness, uint32_t count) {
    const float alpha = roughness * roughness;
    const auto pdf = [&](const vec3& l) {
        const vec3 h = glm::normalize(p.view + l);
        const float g1 = 2 * p.nDotV / (p.nDotV + p.rootV);
        const float visible = g1 * distributionGgx(h.z, p.alpha2) / (4 * p.nDotV);
        return 0.5f * (visible + l.z * kInversePi);
    };
    vec3 sum(0);
    for (uint32_t i = 0; i < count; ++i) {
        const vec2 u = hammersley(i, count);
        const vec3 h = sampleVisibleNormal(p.view, alpha, u);
        const vec3 reflected = 2 * glm::dot(p.view, h) * h - p.view;
        const float ring = std::sqrt(u.x), phi = 2 * kPi * u.y;
        const vec3 cosine(ring * std::cos(phi), ring * std::sin(phi), std::sqrt(1 - u.x));
        for (const vec3& l : {reflected, cosine})
            if (l.z > 0) sum += 0.5f * evaluateBrdf(p, l) / pdf(l);
    }
    return sum / float(count);
}

TEST(Brdf, WhiteMetalLosesEnergyByMaskingAlone) {
    for (const float roughness : {0.1f, 0.3f, 0.6f, 1.0f}) {
        for (const float nDotV : {0.1f, 0.5f, 0.95f}) {
            const auto p = makeShadingPoint(vec3(1), 1, roughness, vec3(0, 0, 1), viewAt(nDotV),
                                            kNoLoss);
            const float albedo = furnace(p, roughness, 16384).x;
            const vec2 table = integrateBrdf(nDotV, roughness, 4096);
            EXPECT_LE(albedo, 1.002f);
            EXPECT_NEAR(albedo, table.x + table.y, 0.004f) << roughness << " " << nDotV;
        }
    }
    const auto rough = makeShadingPoint(vec3(1), 1, 1, vec3(0, 0, 1), viewAt(0.5f), kNoLoss);
    EXPECT_LT(furnace(rough, 1, 16384).x, 0.75f);
}

// The furnace: a white surface under white light is white, by the table that shaders sample.
TEST(Brdf, WhiteUnderDirectWhiteLightIsWhite) {
    SerialJobs jobs;
    const BrdfTable table = makeBrdfTable(jobs);
    for (int step = 0; step <= 10; ++step) {
        const float roughness = clampRoughness(float(step) / 10);
        for (const float nDotV : {0.05f, 0.1f, 0.2f, 0.35f, 0.5f, 0.7f, 0.9f, 1.0f}) {
            const auto reflected = [&](float metallic) {
                return furnace(makeShadingPoint(vec3(1), metallic, roughness, vec3(0, 0, 1),
                                                viewAt(nDotV), table.lookUp(nDotV, roughness)),
                               roughness, 16384)
                    .x;
            };
            EXPECT_NEAR(reflected(0), 1, 0.01f) << "dielectric " << roughness << " " << nDotV;
            EXPECT_LT(reflected(0.5f), 1.02f) << "half metal " << roughness << " " << nDotV;
            EXPECT_NEAR(reflected(1), 1, 0.02f) << "metal " << roughness << " " << nDotV;
        }
    }
}

TEST(Brdf, WhiteUnderAWhiteEnvironmentIsWhite) {
    SerialJobs jobs;
    const BrdfTable table = makeBrdfTable(jobs);
    for (int step = 0; step <= 10; ++step)
        for (const float nDotV : {0.05f, 0.2f, 0.5f, 1.0f})
            for (const float metallic : {0.0f, 1.0f}) {
                const vec3 f0 = glm::mix(vec3(kDielectricF0), vec3(1), metallic);
                const auto w = environmentWeights(
                    vec3(1 - metallic), f0, table.lookUp(nDotV, clampRoughness(float(step) / 10)));
                EXPECT_NEAR(w.specular.x + w.diffuse.x, 1, 0.01f);
            }
}

TEST(Brdf, EnvironmentWeightsOfWhiteAddUpToWhite) {
    for (const float roughness : {0.1f, 0.5f, 1.0f})
        for (const float nDotV : {0.1f, 0.5f, 1.0f}) {
            const vec2 table = integrateBrdf(nDotV, roughness, 1024);
            for (const float metallic : {0.0f, 1.0f}) {
                const vec3 f0 = glm::mix(vec3(kDielectricF0), vec3(1), metallic);
                const auto w = environmentWeights(vec3(1 - metallic), f0, table);
                EXPECT_NEAR(w.specular.x + w.diffuse.x, 1, 1e-5f);
            }
            const auto black = environmentWeights(vec3(0), vec3(kDielectricF0), table);
            EXPECT_LT(black.specular.x + black.diffuse.x, 1);
        }
}

// The energy factors are of the view alone; the lobe that they scale is reciprocal.
TEST(Brdf, TheSpecularLobeIsReciprocal) {
    const vec3 n(0, 0, 1);
    for (uint32_t i = 0; i < 64; ++i) {
        const vec2 a = hammersley(i, 64), b = hammersley(63 - i, 64);
        const auto direction = [](const vec2& u) {
            const float z = 0.05f + 0.95f * u.x, ring = std::sqrt(1 - z * z);
            return vec3(ring * std::cos(6.28f * u.y), ring * std::sin(6.28f * u.y), z);
        };
        const vec3 v = direction(a), l = direction(b), base(.8f, .5f, .2f);
        const vec3 forth = evaluateBrdf(makeShadingPoint(base, 1, .5f, n, v, kNoLoss), l) / l.z;
        const vec3 back = evaluateBrdf(makeShadingPoint(base, 1, .5f, n, l, kNoLoss), v) / v.z;
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(forth[c], back[c], 1e-4f * forth[c]);
    }
}

TEST(Brdf, EqualsTheTextbookFormWithAHalfVector) {
    const vec3 n(0, 0, 1), v = viewAt(0.7f), l = glm::normalize(vec3(-0.4f, 0.5f, 0.6f));
    const float alpha2 = 0.4f * 0.4f * 0.4f * 0.4f;
    const vec3 h = glm::normalize(v + l);
    const float d = alpha2 / (kPi * std::pow(h.z * h.z * (alpha2 - 1) + 1, 2.0f));
    const auto root = [&](float c) { return std::sqrt(alpha2 + (1 - alpha2) * c * c); };
    const float g = 2 * l.z * v.z / (l.z * root(v.z) + v.z * root(l.z));
    const vec3 base(0.9f, 0.3f, 0.1f);
    const float metallic = 0.25f;
    const vec3 f0 = 0.04f * (1 - metallic) + base * metallic;
    const vec3 f = f0 + (1.0f - f0) * std::pow(1 - glm::dot(v, h), 5.0f);
    const vec2 table(0.8f, 0.05f);
    const vec3 compensation = 1.0f + f0 * (1 / 0.85f - 1);
    const vec3 left = 1.0f - (f0 * 0.8f + 0.05f) * compensation;
    const vec3 expected = (f * compensation * d * g / (4 * l.z * v.z) +
                           left * base * (1 - metallic) / kPi) *
                          l.z;
    const vec3 got = evaluateBrdf(makeShadingPoint(base, metallic, 0.4f, n, v, table), l);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], expected[c], 1e-5f);
    EXPECT_EQ(evaluateBrdf(makeShadingPoint(base, 0, 0.4f, n, v, table), vec3(0, 0, -1)), vec3(0));
}

TEST(PunctualLight, AttenuatesAsTheExtensionSays) {
    EXPECT_FLOAT_EQ(distanceAttenuation(4, inverseRangeSquared(0)), 0.25f);
    const float range = 5, d = 3;
    EXPECT_NEAR(distanceAttenuation(d * d, inverseRangeSquared(range)),
                (1 - std::pow(d / range, 4.0f)) / (d * d), 1e-7f);
    EXPECT_EQ(distanceAttenuation(25.01f, inverseRangeSquared(range)), 0);
    EXPECT_TRUE(std::isfinite(distanceAttenuation(0, 0)));
}

TEST(PunctualLight, SpotFallsFromInnerToOuterCone) {
    const vec2 cone = spotScaleOffset(0.3f, 0.6f);
    EXPECT_FLOAT_EQ(spotAttenuation(std::cos(0.2f), cone), 1);
    EXPECT_FLOAT_EQ(spotAttenuation(std::cos(0.7f), cone), 0);
    const float x = (std::cos(0.45f) - std::cos(0.6f)) / (std::cos(0.3f) - std::cos(0.6f));
    EXPECT_NEAR(spotAttenuation(std::cos(0.45f), cone), x * x, 1e-5f);
    EXPECT_EQ(spotAttenuation(-1, vec2(0, 1)), 1);  // a point light
}

TEST(BrdfTable, HasTheLimitsThatMustBe) {
    SerialJobs jobs;
    const BrdfTable table = makeBrdfTable(jobs);
    const vec2 smooth = table.lookUp(1, 0);
    EXPECT_NEAR(smooth.x, 1, 0.005f);
    EXPECT_NEAR(smooth.y, 0, 0.005f);
    for (const vec2& t : table.texels) {
        EXPECT_GE(t.x, 0);
        EXPECT_GE(t.y, 0);
        EXPECT_LE(t.x + t.y, 1.0005f);
    }
    const vec2 exact = integrateBrdf(0.3f, 0.7f, 65536);
    const vec2 stored = table.lookUp(0.3f, 0.7f);
    EXPECT_NEAR(stored.x, exact.x, 0.003f);
    EXPECT_NEAR(stored.y, exact.y, 0.003f);
}

}  // namespace
}  // namespace rushlight

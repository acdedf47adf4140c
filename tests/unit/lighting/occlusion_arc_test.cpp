// The closed integrals of ambient occlusion against sums over the same slice.

#include "interop/occlusion_arc.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rushlight::interop {
namespace {

constexpr double kPi = 3.14159265358979;

/// Light, and its parts across and along the view, between two angles to the view vector; the
/// normal is at `n`.
glm::dvec3 sum(double n, double low, double high) {
    constexpr int kSteps = 20000;
    glm::dvec3 total(0);
    for (int i = 0; i < kSteps; ++i) {
        const double t = low + (high - low) * (i + 0.5) / kSteps;
        const double light = std::cos(t - n) * std::abs(std::sin(t)) * (high - low) / kSteps;
        total += light * glm::dvec3(1, std::sin(t), std::cos(t));
    }
    return total;
}

TEST(OcclusionArc, LossesAreThoseOfASum) {
    for (const double n : {-1.3, -0.4, 0.0, 0.7, 1.5})
        for (const double open0 : {0.0, 0.3, 1.0})
            for (const double open1 : {0.05, 0.6, 1.0}) {
                // Horizons between the view vector and the lowest that the normal allows.
                const double h0 = (n - kPi / 2) * open0, h1 = (n + kPi / 2) * open1;
                const glm::dvec3 expected = sum(n, n - kPi / 2, n + kPi / 2) - sum(n, h0, h1);
                const vec3 lost = arcOccluded(float(std::cos(h0)), float(std::cos(h1)),
                                              float(std::cos(n)), float(std::sin(n)));
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(lost[c], expected[c], 3e-4) << n << ": " << h0 << " to " << h1;
            }
}

TEST(OcclusionArc, AnOpenSliceLosesNothing) {
    for (float n = -1.5f; n <= 1.5f; n += 0.1f) {
        const float s = std::sin(n), c = std::sqrt(1 - s * s);
        const vec3 lost = arcOccluded(s, -s, c, s);
        EXPECT_LT(glm::length(lost), 2e-6f) << n;
    }
}

TEST(OcclusionArc, ArcCosineIsNearAndEven) {
    for (float x = 0; x <= 1; x += 0.001f) {
        EXPECT_NEAR(arcCosine(x), std::acos(x), 7e-5f);
        EXPECT_EQ(arcCosine(-x), x > 0 ? 2 * kHalfPi - arcCosine(x) : arcCosine(x));
    }
}

}  // namespace
}  // namespace rushlight::interop

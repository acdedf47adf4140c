#include "interop/tonemap.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rushlight {
namespace {

using namespace interop;
using Curve = vec3 (*)(vec3);

TEST(ToneMap, GreysRiseAndStayInRange) {
    for (const Curve curve : {Curve(toneMapNeutral), Curve(toneMapAces), Curve(toneMapAgx)}) {
        float last = -1;
        for (float x = 1e-4f; x < 1e4f; x *= 1.05f) {
            const vec3 out = curve(vec3(x));
            EXPECT_GE(out.x, last - 1e-6f) << x;
            last = out.x;
            for (int c = 0; c < 3; ++c) {
                EXPECT_GE(out[c], 0) << x;
                EXPECT_LE(out[c], 1.005f) << x;
            }
        }
        EXPECT_GT(last, 0.95f);
    }
}

TEST(ToneMap, NeutralKeepsDielectricsAndCompressesHighlights) {
    // Below the shoulder: the darkest channel loses Fresnel's 0.04, the others as much.
    const vec3 out = toneMapNeutral({0.5f, 0.3f, 0.2f});
    EXPECT_NEAR(out.x, 0.46f, 1e-6f);
    EXPECT_NEAR(out.y, 0.26f, 1e-6f);
    EXPECT_NEAR(out.z, 0.16f, 1e-6f);
    // x = 1: peak 0.96, room 0.24: 1 - 0.0576 / (0.96 + 0.24 - 0.76)
    EXPECT_NEAR(toneMapNeutral(vec3(1)).x, 1 - 0.0576f / 0.44f, 1e-5f);
    const vec3 red = toneMapNeutral({100, 0, 0});
    EXPECT_GT(red.y, 0.9f);  // very bright colours go to white
}

TEST(ToneMap, AcesOfMiddleGreyByHand) {
    // Both matrices have rows that sum to about 1, so a grey x is a rational function of x / 0.6.
    const double x = 0.18 / 0.6;
    const double v = x * (x + 0.0245786) - 0.000090537;
    const double expected = v / (x * (0.983729 * x + 0.4329510) + 0.238081);
    EXPECT_NEAR(toneMapAces(vec3(0.18f)).x, expected, 2e-4);
    EXPECT_EQ(toneMapAces(vec3(0)), vec3(0));
}

TEST(ToneMap, AgxOfMiddleGreyIsHalfTheSignal) {
    // AgX's curve pivots there: 0.18 comes out as a signal of one half, linear 0.5^2.2; the fit is
    // within 1 %.
    const vec3 grey = toneMapAgx(vec3(0.18f));
    EXPECT_NEAR(std::pow(grey.x, 1 / 2.2f), 0.5f, 0.01f);
    EXPECT_NEAR(grey.x, grey.y, 1e-3f);
    EXPECT_LT(toneMapAgx(vec3(0)).x, 1e-4f);
    EXPECT_GT(toneMapAgx(vec3(100)).x, 0.97f);
    // Saturated light desaturates towards white as it gets brighter.
    const vec3 blue = toneMapAgx({0, 0, 50});
    EXPECT_GT(blue.x, 0.3f);
}

TEST(Srgb, KnownValuesAndInverse) {
    EXPECT_EQ(encodeSrgb(0.0f), 0);
    EXPECT_NEAR(encodeSrgb(1.0f), 1, 1e-6f);
    EXPECT_NEAR(encodeSrgb(0.5f), 0.735357f, 1e-5f);
    EXPECT_NEAR(encodeSrgb(0.002f), 0.02584f, 1e-6f);
    for (float x = 0; x <= 1; x += 1.0f / 512) EXPECT_NEAR(decodeSrgb(encodeSrgb(x)), x, 1e-6f);
}

TEST(Dither, KeepsTheMeanAndBlackAndWhite) {
    for (const float level : {0.0f, 10.3f, 100.5f, 200.9f, 255.0f}) {
        double sum = 0, changed = 0;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const vec3 color = dithered(vec3(level / 255), vec2(x, y) + 0.5f);
                const float shown = std::round(color.x * 255);
                sum += shown;
                changed += std::abs(shown - level) > 1e-4f;
                EXPECT_EQ(color.x, color.z);
            }
        EXPECT_NEAR(sum / (64 * 64), level, 0.02) << level;
        if (level == 0 || level == 255) {
            EXPECT_EQ(changed, 0) << level;
        }
    }
}

}  // namespace
}  // namespace rushlight

#include "renderer/capture/compare/compare.h"
#include "renderer/capture/compare/hdr_flip.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rushlight {
namespace {

Picture uniform(uint32_t width, uint32_t height, vec3 color, bool linear = false) {
    Picture picture{width, height, linear, {}};
    for (size_t i = 0; i < picture.pixelCount(); ++i)
        picture.rgba.insert(picture.rgba.end(), {color.r, color.g, color.b, 1.0f});
    return picture;
}

/// A smooth pattern with an edge, so that every part of the measures has something to do.
Picture pattern(uint32_t width, uint32_t height, float shift) {
    Picture picture{width, height, false, {}};
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const float u = float(x) + shift;
            const float v = float(y);
            picture.rgba.insert(picture.rgba.end(),
                                {0.5f + 0.4f * std::sin(u * 0.31f), u > 20 ? 0.8f : 0.2f,
                                 0.5f + 0.3f * std::cos(v * 0.2f + u * 0.05f), 1.0f});
        }
    return picture;
}

Comparison compared(const Picture& a, const Picture& b) {
    auto result = comparePictures(a, b, "a", "b");
    EXPECT_TRUE(result) << result.error().text();
    return *result;
}

TEST(Compare, EqualPicturesHaveNoError) {
    const Comparison c = compared(pattern(40, 30, 0), pattern(40, 30, 0));
    EXPECT_TRUE(std::isinf(c.psnr));
    EXPECT_EQ(c.maxError, 0);
    EXPECT_EQ(c.meanError, 0);
    EXPECT_NEAR(c.ssim, 1, 1e-6);
    EXPECT_EQ(c.flip, 0);
}

TEST(Compare, UniformPicturesHaveErrorsOneCanWorkOutByHand) {
    const Comparison c = compared(uniform(16, 16, vec3(0.5f)), uniform(16, 16, vec3(0.6f)));
    EXPECT_NEAR(c.maxError, 0.1, 1e-6);
    EXPECT_NEAR(c.meanError, 0.1, 1e-6);
    EXPECT_NEAR(c.psnr, 20, 1e-4);  // -10 log10(0.1²)
    // Without variance SSIM is (2 ux uy + C1) / (ux² + uy² + C1).
    EXPECT_NEAR(c.ssim, (2 * 0.3 + 1e-4) / (0.25 + 0.36 + 1e-4), 1e-4);
}

// Equal means and variances; the covariance is minus the variance, so that structure counts -1.
TEST(Compare, ANegativeHasTheOppositeStructure) {
    Picture checks{32, 32, false, {}}, negative{32, 32, false, {}};
    for (uint32_t i = 0; i < 32 * 32; ++i) {
        const float value = (i % 32 + i / 32) % 2 ? 0.7f : 0.3f;
        checks.rgba.insert(checks.rgba.end(), {value, value, value, 1});
        negative.rgba.insert(negative.rgba.end(), {1 - value, 1 - value, 1 - value, 1});
    }
    EXPECT_NEAR(compared(checks, negative).ssim, -0.95, 0.05);
}

TEST(Compare, OneWrongPixelIsTheMaximumAndASmallMean) {
    Picture b = uniform(10, 10, vec3(0.5f));
    b.rgba[4 * 55 + 1] = 1;
    const Comparison c = compared(uniform(10, 10, vec3(0.5f)), b);
    EXPECT_NEAR(c.maxError, 0.5, 1e-6);
    EXPECT_NEAR(c.meanError, 0.5 / 300, 1e-6);
    EXPECT_NEAR(c.psnr, -10 * std::log10(0.25 / 300), 1e-4);
}

TEST(Compare, FlipOfBlackAndWhite) {
    // By hand from the paper: HyAB of black and white is 100, of Hunt-adjusted green and blue
    // 203.37. Below the exponent 0.7: 25.12 and 41.27, so that the error is 0.95 + (25.12 - 16.51)
    // / (41.27 - 16.51) * 0.05.
    const Comparison c = compared(uniform(8, 8, vec3(0)), uniform(8, 8, vec3(1)));
    EXPECT_NEAR(c.flip, 0.9674, 2e-4);
}

TEST(Compare, FlipOfGreenAndBlueIsTheLargest) {
    const Comparison c = compared(uniform(8, 8, {0, 1, 0}), uniform(8, 8, {0, 0, 1}));
    EXPECT_NEAR(c.flip, 1, 1e-4);
}

TEST(Compare, FlipIsSymmetricAndGrowsWithTheDifference) {
    const Picture a = pattern(48, 32, 0);
    const double small = compared(a, pattern(48, 32, 0.5f)).flip;
    const double large = compared(a, pattern(48, 32, 3)).flip;
    EXPECT_GT(small, 0);
    EXPECT_GT(large, small);
    EXPECT_NEAR(compared(pattern(48, 32, 3), a).flip, large, 1e-6);
}

TEST(Compare, AlphaCountsWhereItIsNotOpaque) {
    Picture b = uniform(4, 4, vec3(0));
    for (size_t i = 3; i < b.rgba.size(); i += 4) b.rgba[i] = 0;
    const Comparison c = compared(uniform(4, 4, vec3(0)), b);
    EXPECT_EQ(c.maxError, 1);
    EXPECT_NEAR(c.meanError, 0.25, 1e-9);
}

TEST(Compare, LinearPicturesKeepTheirRangeInTheErrors) {
    const Comparison c = compared(uniform(12, 12, vec3(10), true), uniform(12, 12, vec3(14), true));
    EXPECT_NEAR(c.maxError, 4, 1e-6);
    EXPECT_GT(c.flip, 0.05);  // both would be white if they were cut to what a display shows
}

TEST(Compare, ExposuresGoFromTheBrightestPixelToTheMedian) {
    // The curve of the paper gives 0.85 for 0.6 x with 0.4445 x² - 0.4715 x - 0.119 = 0: x
    // = 1.2713, radiance 2.1189.
    const float target = std::log2(2.1189f);
    std::vector<vec3> pixels(9, vec3(0.25f));
    pixels[4] = vec3(64);
    pixels[5] = vec3(0);  // nobody sees what has no light
    pixels[6] = vec3(std::nanf(""));
    const ExposureRange range = exposureRange(pixels);
    EXPECT_NEAR(range.first, target - 6, 1e-3);
    EXPECT_NEAR(range.last, target + 2, 1e-3);
    EXPECT_EQ(range.count, 8u);
    EXPECT_NEAR(range.stops(7), range.last, 1e-5);
    const ExposureRange black = exposureRange(std::vector<vec3>(4, vec3(0)));
    EXPECT_EQ(black.first, black.last);
    EXPECT_NEAR(black.first, target, 1e-3);
}

TEST(Compare, HdrFlipIsTheWorstOfTheExposures) {
    // Uniform pictures have one exposure: the reference is shown as 0.85, the test, of twice the
    // light, as x = 2.5426: 0.9397. FLIP of those greys by the low dynamic range function.
    const double hdr = compared(uniform(12, 12, vec3(3), true), uniform(12, 12, vec3(6), true))
                           .flip;
    const std::vector<vec3> a(144, vec3(0.85f)), b(144, vec3(0.9397f));
    EXPECT_NEAR(hdr, flipErrors(a, b, 12, 12, kDefaultPixelsPerDegree).values[0], 1e-4);
    // In the light of a lamp of 1000 the dark half of the picture would be black: its error is seen
    // all the same.
    Picture lit = uniform(64, 64, vec3(0.02f), true), wrong = lit;
    for (Picture* picture : {&lit, &wrong})
        for (size_t i = 0; i < 64 * 16 * 4; i += 4)
            std::fill_n(picture->rgba.begin() + ptrdiff_t(i), 3, 1000.0f);
    for (size_t i = 64 * 48 * 4; i < wrong.rgba.size(); i += 4)
        std::fill_n(wrong.rgba.begin() + ptrdiff_t(i), 3, 0.01f);
    EXPECT_GT(compared(lit, wrong).flipErrors.values[64 * 62], 0.2);
    EXPECT_LT(compared(lit, wrong).flipErrors.values[64 * 30], 0.01);
}

TEST(Compare, AlphaOverlapIsOfWhatEitherCovers) {
    Picture a = uniform(4, 4, vec3(0)), b = a;
    EXPECT_EQ(compared(a, b).alphaOverlap, 1);
    for (size_t i = 0; i < 8; ++i) a.rgba[i * 4 + 3] = 0;   // the lower half is left
    for (size_t i = 4; i < 16; ++i) b.rgba[i * 4 + 3] = 0;  // the first row is left
    EXPECT_EQ(compared(a, b).alphaOverlap, 0);
    for (size_t i = 8; i < 12; ++i) b.rgba[i * 4 + 3] = 0.5f;
    EXPECT_NEAR(compared(a, b).alphaOverlap, 4.0 / 12, 1e-9);
}

TEST(Compare, EveryPixelHasItsLargestError) {
    Picture b = uniform(10, 10, vec3(0.5f));
    b.rgba[4 * 55 + 1] = 1;
    b.rgba[4 * 55 + 2] = 0.4f;
    const Comparison c = compared(uniform(10, 10, vec3(0.5f)), b);
    EXPECT_NEAR(c.errors.values[55], 0.5, 1e-6);
    EXPECT_EQ(c.errors.values[54], 0);
}

TEST(Compare, ANotANumberIsAnInfiniteError) {
    Picture b = uniform(4, 4, vec3(0.5f), true);
    b.rgba[0] = std::nanf("");
    const Comparison c = compared(uniform(4, 4, vec3(0.5f), true), b);
    EXPECT_TRUE(std::isinf(c.maxError));
    EXPECT_FALSE(std::isnan(c.flip));
}

TEST(Compare, SizesAndKindsMustAgree) {
    const auto size = comparePictures(uniform(4, 4, vec3(0)), uniform(4, 5, vec3(0)), "a.png",
                                      "b.png");
    ASSERT_FALSE(size);
    EXPECT_EQ(size.error().object, "b.png");
    EXPECT_EQ(size.error().message,
              "The picture has 4x5 pixels and a.png has 4x4; pictures of one size are compared.");
    EXPECT_FALSE(comparePictures(uniform(4, 4, vec3(0)), uniform(4, 4, vec3(0), true), "a", "b"));
}

TEST(Compare, TheHeatMapGoesFromBlackToNearlyWhite) {
    Plane errors(3, 1);
    errors.values = {0, 0.5f, 1};
    const auto rgba = heatMap(errors);
    ASSERT_EQ(rgba.size(), 12u);
    EXPECT_EQ(rgba[0] + rgba[1] + rgba[2], 0);
    EXPECT_EQ(rgba[8], 255);
    EXPECT_EQ(rgba[9], 255);
    EXPECT_GT(rgba[4] + rgba[5] + rgba[6], 150);
}

}  // namespace
}  // namespace rushlight

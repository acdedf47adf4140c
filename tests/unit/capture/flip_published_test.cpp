// FLIP and HDR-FLIP against the program that their authors published: python/flip_api.py of
// NVlabs/flip as of 2021 (two dimensional kernels, single precision), run on these pictures with
// its defaults.
#include "renderer/capture/compare/compare.h"
#include "renderer/capture/compare/hdr_flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

constexpr int kWidth = 96, kHeight = 64;

bool inDisk(int x, int y) { return (x - 48) * (x - 48) + (y - 32) * (y - 32) < 300; }

/// Ramps that wrap, which are edges, on a chessboard of 8 pixels.
int ramp(int x, int y, int c) {
    return (x * (3 + c) + y * (5 - c) + (((x >> 3) + (y >> 3)) & 1) * 90 + c * 40) & 255;
}
int noisy(int x, int y, int c) { return std::min(255, ramp(x, y, c) + (x * x + y * y * 3) % 17); }
int diskInverted(int x, int y, int c) { return inDisk(x, y) ? 255 - ramp(x, y, c) : ramp(x, y, c); }
int moved(int x, int y, int c) { return ramp((x - 2) & 255, y, c); }

template <class Value>
Picture picture(bool linear, Value value) {
    Picture result{kWidth, kHeight, linear, {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            for (int c = 0; c < 3; ++c) result.rgba.push_back(value(x, y, c));
            result.rgba.push_back(1);
        }
    return result;
}

Picture ofBytes(int (*byte)(int, int, int)) {
    return picture(false, [=](int x, int y, int c) { return float(byte(x, y, c)) / 255; });
}

/// Eight steps of light, each double the one before it.
float radiance(int x, int y, int c) {
    return float(1 + ramp(x, y, c)) / 256 * std::exp2(float(x / 12 - 3));
}
float grainy(int x, int y, int c) {
    return radiance(x, y, c) * (1 + float((x * 7 + y * 11 + c) % 8) / 16);
}
float brightDisk(int x, int y, int c) { return radiance(x, y, c) * (inDisk(x, y) ? 4.0f : 1.0f); }

void expectFlip(const Picture& reference, const Picture& test, double mean, double largest) {
    const auto compared = comparePictures(reference, test, "reference", "test");
    ASSERT_TRUE(compared) << compared.error().text();
    EXPECT_NEAR(compared->flip, mean, 2e-6);
    EXPECT_NEAR(std::ranges::max(compared->flipErrors.values), largest, 1e-5);
}

TEST(FlipPublished, NoiseAnInvertedDiskAndAShift) {
    const Picture reference = ofBytes(ramp);
    expectFlip(reference, ofBytes(noisy), 0.1753204, 0.2848250);
    expectFlip(reference, ofBytes(diskInverted), 0.1631455, 0.9845188);
    expectFlip(reference, ofBytes(moved), 0.4955748, 0.9847937);
}

TEST(FlipPublished, RadianceWithGrainAndABrighterDisk) {
    const Picture reference = picture(true, radiance);
    expectFlip(reference, picture(true, grainy), 0.2239648, 0.3358576);
    expectFlip(reference, picture(true, brightDisk), 0.1512164, 0.8957794);
}

TEST(FlipPublished, Exposures) {
    std::vector<vec3> pixels;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            pixels.emplace_back(radiance(x, y, 0), radiance(x, y, 1), radiance(x, y, 2));
    const ExposureRange range = exposureRange(pixels);
    EXPECT_NEAR(range.first, -2.7094313, 1e-5);
    EXPECT_NEAR(range.last, 1.6092825, 1e-5);
    EXPECT_EQ(range.count, 5u);
}

}  // namespace
}  // namespace rushlight

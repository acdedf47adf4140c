// Half floats, on every set of instructions that this machine has.
#include "renderer/rhi/half_floats.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <glm/gtc/packing.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace rushlight {
namespace {

template <class Check>
void onAllTargets(Check check) {
    for (const int64_t target : hwy::SupportedAndGeneratedTargets()) {
        SCOPED_TRACE(hwy::TargetName(target));
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        check();
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

std::vector<uint16_t> allHalves() {
    std::vector<uint16_t> all(65536);
    std::iota(all.begin(), all.end(), uint16_t(0));
    return all;
}

TEST(HalfFloats, EveryHalfIsItsFloatAndComesBack) {
    const std::vector<uint16_t> halves = allHalves();
    onAllTargets([&] {
        std::vector<float> floats(halves.size());
        floatsFromHalves(std::as_bytes(std::span(halves)), floats);
        for (size_t i = 0; i < halves.size(); ++i) {
            const float expected = glm::unpackHalf1x16(halves[i]);
            ASSERT_EQ(std::isnan(floats[i]), std::isnan(expected)) << i;
            if (std::isnan(expected)) continue;
            ASSERT_EQ(std::bit_cast<uint32_t>(floats[i]), std::bit_cast<uint32_t>(expected)) << i;
        }
        std::vector<uint16_t> back(halves.size());
        EXPECT_TRUE(exactHalves(floats, back));
        EXPECT_EQ(back, halves);
    });
}

TEST(HalfFloats, AnyCountAtAnyEvenAddress) {
    onAllTargets([] {
        for (size_t count = 0; count < 40; ++count) {
            std::vector<std::byte> bytes(count * 2 + 2);
            for (size_t i = 0; i < count; ++i) {
                const uint16_t half = glm::packHalf1x16(float(i) + 0.5f);
                bytes[2 + i * 2] = std::byte(half & 255);
                bytes[3 + i * 2] = std::byte(half >> 8);
            }
            std::vector<float> floats(count + 1, -1.0f);
            floatsFromHalves(std::span(bytes).subspan(2), std::span(floats).first(count));
            for (size_t i = 0; i < count; ++i) EXPECT_EQ(floats[i], float(i) + 0.5f);
            EXPECT_EQ(floats[count], -1);
            std::vector<uint16_t> halves(count + 1, 7);
            EXPECT_TRUE(
                exactHalves(std::span(floats).first(count), std::span(halves).first(count)));
            for (size_t i = 0; i < count; ++i)
                EXPECT_EQ(halves[i], glm::packHalf1x16(float(i) + 0.5f));
            EXPECT_EQ(halves[count], 7);
        }
    });
}

TEST(HalfFloats, WhatIsNoHalfIsSaid) {
    onAllTargets([] {
        for (const float odd : {0.1f, 65536.0f, 1e-9f, 1 + 0x1p-11f, 65520.0f})
            for (size_t at = 0; at < 21; ++at) {
                std::vector<float> floats(21, 1.0f);
                std::vector<uint16_t> halves(21);
                EXPECT_TRUE(exactHalves(floats, halves));
                floats[at] = odd;
                EXPECT_FALSE(exactHalves(floats, halves)) << odd << " at " << at;
            }
        std::vector<uint16_t> halves(2);
        const float infinity = std::numeric_limits<float>::infinity();
        EXPECT_TRUE(exactHalves(std::vector<float>{infinity, -0.0f}, halves));
        EXPECT_EQ(halves, (std::vector<uint16_t>{0x7c00, 0x8000}));
    });
}

}  // namespace
}  // namespace rushlight

#include "sandbox/game/lamps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

std::vector<PunctualLight> threeLights() {
    std::vector<PunctualLight> lights(3);
    lights[0].position = {0, 3, 0};
    lights[1].position = {2.5f, 3, 0};
    lights[2].position = {20, 3, 0};
    return lights;
}
const std::vector<std::string> kNames{"lamp01.light", "lamp02.light", "spot.gate"};

TEST(FlickerTest, IsTheSameEveryTimeAndStaysNearOne) {
    float low = 2;
    float high = 0;
    for (int i = 0; i < 2000; ++i) {
        const double time = i * 0.037;
        const float value = flicker(3, time);
        EXPECT_EQ(value, flicker(3, time));
        low = std::min(low, value);
        high = std::max(high, value);
    }
    EXPECT_GE(low, 0.92f);
    EXPECT_LE(high, 1.08f);
    EXPECT_GT(high - low, 0.05f) << "it does flicker";
}

TEST(FlickerTest, IsContinuousAndDiffersFromLampToLamp) {
    float difference = 0;
    for (int i = 0; i < 2000; ++i) {
        const double time = i * 0.013;
        EXPECT_LT(std::abs(flicker(1, time + 0.001) - flicker(1, time)), 0.01f);
        difference = std::max(difference, std::abs(flicker(1, time) - flicker(2, time)));
    }
    EXPECT_GT(difference, 0.03f);
}

TEST(LampsTest, OnlyLampsCountAndThoseInReachAreLitTogether) {
    auto lights = threeLights();
    Lamps lamps;
    lamps.gather(lights, kNames);
    ASSERT_EQ(lamps.count(), 2u);
    EXPECT_EQ(lamps.litCount(), 0u);
    EXPECT_FALSE(lamps.canLightAt({8, 1.7f, 0}));
    ASSERT_TRUE(lamps.canLightAt({0.5f, 1.7f, 1}));
    lamps.lightAround({0.5f, 1.7f, 1}, 5);
    EXPECT_TRUE(lamps.allLit());
    EXPECT_FALSE(lamps.canLightAt({0.5f, 1.7f, 1}));
}

TEST(LampsTest, KindleFromDarkToFullAndLeaveOtherLightsAlone) {
    auto lights = threeLights();
    Lamps lamps;
    lamps.gather(lights, kNames);
    const auto brightness = [&](double time) {
        auto scaled = threeLights();
        lamps.apply(scaled, time);
        EXPECT_EQ(scaled[2].intensity, vec3(1));
        return scaled[0].intensity.x;
    };
    EXPECT_LT(brightness(4), 0.03f);
    lamps.lightAll(5);
    EXPECT_LT(brightness(5.01), 0.03f);
    EXPECT_GT(brightness(5 + Lamps::kKindleTime), 0.9f);
}

TEST(LampsTest, WhatBurnsGoesOnBurningWhenTheLevelIsLoadedAgain) {
    auto lights = threeLights();
    Lamps lamps;
    lamps.gather(lights, kNames);
    lamps.lightAround({-2.5f, 1.7f, 0}, 5);
    ASSERT_EQ(lamps.litCount(), 1u);
    std::swap(lights[0], lights[2]);
    const std::vector<std::string> names{"spot.gate", "lamp02.light", "lamp01.light"};
    lamps.gather(lights, names);
    EXPECT_EQ(lamps.litCount(), 1u);
    for (const Lamp& lamp : lamps.all()) EXPECT_EQ(lamp.lit, lamp.name == "lamp01.light");
}

}  // namespace
}  // namespace rushlight

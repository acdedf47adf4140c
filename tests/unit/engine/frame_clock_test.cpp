#include "engine/time/frame_clock.h"

#include <gtest/gtest.h>

namespace rushlight {
namespace {

TEST(FrameClockTest, StartsAtZeroWhateverTheClockSays) {
    FrameClock clock;
    clock.tick(12345);
    EXPECT_EQ(clock.delta(), 0);
    EXPECT_EQ(clock.elapsed(), 0);
    clock.tick(12345.02);
    EXPECT_NEAR(clock.delta(), 0.02, 1e-9);
}

TEST(FrameClockTest, ALongPauseIsShortened) {
    FrameClock clock;
    clock.tick(0);
    clock.tick(60);
    EXPECT_EQ(clock.delta(), FrameClock::kMaxDelta);
    EXPECT_EQ(clock.rawDelta(), 60);
    EXPECT_EQ(clock.elapsed(), FrameClock::kMaxDelta);
}

TEST(FrameClockTest, AClockThatRunsBackwardsStandsStill) {
    FrameClock clock;
    clock.tick(5);
    clock.tick(4);
    EXPECT_EQ(clock.delta(), 0);
    clock.tick(4.1);
    EXPECT_NEAR(clock.delta(), 0.1, 1e-9);
}

TEST(FixedStepTest, TheNumberOfStepsDoesNotDependOnTheFrameRate) {
    for (const int rate : {5, 30, 50, 60, 144, 240}) {
        FixedStep clock(1.0 / 60);
        uint32_t steps = 0;
        for (int frame = 0; frame < 2 * rate; ++frame) steps += clock.advance(1.0 / rate);
        EXPECT_EQ(steps, 120u) << rate;
        EXPECT_NEAR(clock.fraction(), 0, 1e-6) << rate;
    }
}

TEST(FixedStepTest, TheFractionLiesBetweenTwoSteps) {
    FixedStep clock(0.1);
    EXPECT_EQ(clock.advance(0.25), 2u);
    EXPECT_NEAR(clock.fraction(), 0.5, 1e-9);
}

TEST(FrameRateMeterTest, OneHitchDoesNotMoveTheMedian) {
    FrameRateMeter meter;
    EXPECT_EQ(meter.framesPerSecond(), 0);
    for (int i = 0; i < 30; ++i) meter.add(0.01);
    meter.add(2);
    EXPECT_NEAR(meter.medianSeconds(), 0.01, 1e-12);
    EXPECT_NEAR(meter.framesPerSecond(), 100, 1e-9);
}

TEST(FrameRateMeterTest, OldFramesAreForgotten) {
    FrameRateMeter meter;
    for (int i = 0; i < 100; ++i) meter.add(1);
    for (uint32_t i = 0; i < FrameRateMeter::kFrames; ++i) meter.add(0.02);
    EXPECT_NEAR(meter.medianSeconds(), 0.02, 1e-12);
}

}  // namespace
}  // namespace rushlight

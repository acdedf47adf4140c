#include "engine/time/frame_clock.h"

#include <algorithm>

namespace rushlight {

void FrameClock::tick(double now) {
    rawDelta_ = running_ ? std::max(now - last_, 0.0) : 0.0;
    delta_ = std::min(rawDelta_, kMaxDelta);
    elapsed_ += delta_;
    last_ = now;
    running_ = true;
}

uint32_t FixedStep::advance(double delta) {
    // A sum of many deltas that should be a whole number of steps falls short of it by rounding.
    constexpr double kRounding = 1e-9;
    remainder_ += delta;
    const auto steps = uint32_t((remainder_ + kRounding) / step_);
    remainder_ = std::max(remainder_ - steps * step_, 0.0);
    return steps;
}

void FrameRateMeter::add(double seconds) {
    seconds_[next_] = seconds;
    next_ = (next_ + 1) % kFrames;
    count_ = std::min(count_ + 1, kFrames);
}

double FrameRateMeter::medianSeconds() const {
    if (count_ == 0) return 0;
    std::array<double, kFrames> sorted = seconds_;
    const auto middle = sorted.begin() + count_ / 2;
    std::nth_element(sorted.begin(), middle, sorted.begin() + count_);
    return *middle;
}

double FrameRateMeter::framesPerSecond() const {
    const double median = medianSeconds();
    return median > 0 ? 1 / median : 0;
}

}  // namespace rushlight

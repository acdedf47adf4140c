#pragma once
// Time as an input: the host reads its clock and hands the value in, so that a test or a replay can
// too.

#include <array>
#include <cstdint>

namespace rushlight {

/// The time of a frame and the time since the one before it.
class FrameClock {
public:
    /// A frame that took longer (a breakpoint, a window being dragged) counts as this long.
    static constexpr double kMaxDelta = 0.25;

    /// `now` in seconds of any monotonic clock. A clock that runs backwards gives a delta of zero.
    void tick(double now);

    double delta() const { return delta_; }  ///< seconds in [0, kMaxDelta]; 0 in the first frame
    double rawDelta() const { return rawDelta_; }  ///< seconds, not clamped
    double elapsed() const { return elapsed_; }    ///< the sum of the deltas

private:
    double last_ = 0;
    double delta_ = 0;
    double rawDelta_ = 0;
    double elapsed_ = 0;
    bool running_ = false;
};

/// Turns frames of any length into steps of one length, so that a simulation does not depend on the
/// frame rate.
class FixedStep {
public:
    explicit FixedStep(double seconds) : step_(seconds) {}

    /// How many steps are due after `delta` more seconds.
    uint32_t advance(double delta);
    double step() const { return step_; }
    /// How far the frame is between the last step and the next, in [0, 1).
    double fraction() const { return remainder_ / step_; }

private:
    double step_;
    double remainder_ = 0;
};

/// The median length of the last frames: one hitch does not move it.
class FrameRateMeter {
public:
    static constexpr uint32_t kFrames = 61;

    void add(double seconds);
    double medianSeconds() const;  ///< 0 before the first frame
    double framesPerSecond() const;

private:
    std::array<double, kFrames> seconds_{};
    uint32_t next_ = 0;
    uint32_t count_ = 0;
};

}  // namespace rushlight

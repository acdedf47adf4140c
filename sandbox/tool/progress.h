#pragma once
// How far long work is.

#include <chrono>
#include <cstdint>

namespace rushlight::tool {

/// One line on a terminal, "frame 12 of 240, 1:05 left", written over itself; nothing into a pipe.
class Progress {
public:
    /// `what` is done one after another; it must live as long as this.
    explicit Progress(const char* what);

    /// Of `count`, `done` are, `free` of which took no time: they were there already.
    void show(uint64_t done, uint64_t count, uint64_t free = 0) const;

private:
    using Clock = std::chrono::steady_clock;

    const char* what_;
    const bool onTerminal_;
    const Clock::time_point start_ = Clock::now();
};

}  // namespace rushlight::tool

#pragma once
// When each pass began on the GPU and what it cost, from timestamps; they nest in whatever timer
// query the host may have open.

#include "renderer/backend/gl/gl_functions.h"
#include "renderer/rhi/device.h"

#include <array>
#include <chrono>
#include <string_view>
#include <vector>

namespace rushlight {

class GlTimers {
public:
    using Clock = std::chrono::steady_clock;

    struct Time {
        double beginMs = 0;  ///< since the frame began, as the CPU's clock has it
        double milliseconds = 0;
    };

    explicit GlTimers(const GlFunctions& gl) : gl_(gl) {}
    ~GlTimers();

    /// To be called before each frame; asks the driver for its time at the first and then at every
    /// 64th: clocks drift by microseconds a second, and drivers with threads of their own must be
    /// waited for.
    void compareClocks();

    /// Collects the results that are there, then opens a frame. Never waits: while every frame of
    /// the ring is still with the GPU, the frame is not timed.
    void beginFrame(bool enabled, uint64_t number, Clock::time_point began);
    void beginPass(std::string_view name);
    void endPass();
    void endFrame();

    /// Number of the newest finished frame, kNoFrame before there is one.
    uint64_t newestFrame() const { return newestFrame_; }

    /// In the newest finished frame, of its pass of this index if it has this name, else of its
    /// first pass that has; zeros without one.
    Time newest(uint32_t index, std::string_view name) const;

private:
    static constexpr uint32_t kFrames = 4;
    struct Pass {
        GLuint begin = 0, end = 0;  ///< queries
        uint64_t name = 0;          ///< hash
    };
    struct Frame {
        std::vector<Pass> passes;  ///< of this frame are the first `used`
        uint32_t used = 0;
        bool pending = false;
        uint64_t number = 0;
        GLint64 began = 0;  ///< nanoseconds of the GPU's clock
    };
    struct PassTime {
        uint64_t name;
        Time time;
    };
    GLuint createQuery(std::string_view label) const;
    void collect(Frame& frame);

    const GlFunctions& gl_;
    std::array<Frame, kFrames> frames_;
    uint32_t next_ = 0;
    Frame* open_ = nullptr;
    std::vector<PassTime> newest_;
    uint64_t newestFrame_ = kNoFrame;
    uint32_t untilCompared_ = 0;
    GLint64 gpuAhead_ = 0;  ///< nanoseconds, of the CPU's clock
};

}  // namespace rushlight

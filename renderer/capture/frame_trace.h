#pragma once
// Timelines of drawn frames in the Trace Event Format, which Perfetto (ui.perfetto.dev) and
// chrome://tracing open. Format: "Trace Event Format", Google, 2016 (complete events "X", counters
// "C", metadata "M"; microseconds).

#include "renderer/frame/frame_report.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rushlight {

/// When a frame was drawn, by the host's clock in milliseconds, and what only the host can measure
/// of it.
struct FrameTiming {
    double beginMs = 0;  ///< since the trace's start
    double wallMs = 0;
    uint64_t allocations = 0;
    bool warmUp = false;
};

/// One process with the tracks "CPU" (frame > build, execute > passes), "GPU" (frame > passes), in
/// the render-thread mode "Serving thread" (execute > passes), and counters, all by the host's
/// clock. Begins and durations are measured; an event that would begin, by the rounding of clocks,
/// before the one before it on its track has ended begins with that end. A frame's GPU times arrive
/// with a later frame's report: those of the last frames of a trace are missing, and those of
/// frames that it does not have are left out. What has no GPU time is not on the GPU's track.
class FrameTrace {
public:
    /// Frames come in order; one that begins before the one before it has ended is moved behind it.
    void add(const FrameReport& report, const FrameTiming& timing);

    /// Why there are no more frames, for the file's metadata.
    void setError(std::string_view text) { error_ = text; }

    uint32_t frames() const { return frames_; }

    /// The whole file: valid after any number of frames. `device` and `version` as the renderer
    /// tells them.
    std::string json(std::string_view device, std::string_view version) const;

private:
    /// Of a frame that was added, for what is told of it later. Times are nanoseconds.
    struct Known {
        std::optional<uint64_t> number;
        int64_t begin = 0;
        int64_t executeBegin = 0;
        bool executed = false;
        std::vector<std::pair<std::string, std::string>> passes;  ///< name and arguments
    };
    struct Execution {
        int64_t end = 0;
        std::string events;
    };
    Known* known(uint64_t number);
    Execution execution(const FrameReport& report, Known& frame, int track, int64_t earliest);
    void addGpu(const FrameReport& report);

    std::array<Known, 16> recent_;  ///< by number modulo its size
    std::string events_;            ///< one a line, each with a comma before it
    std::string error_;
    int64_t cpuEnd_ = 0, servingEnd_ = 0, gpuEnd_ = 0;  ///< of their tracks; 0: nothing is on it
    std::optional<uint64_t> lastOnGpu_;
    uint32_t frames_ = 0;
};

}  // namespace rushlight

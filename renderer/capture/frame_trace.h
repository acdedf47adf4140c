#pragma once
// Timelines of drawn frames in the Trace Event Format, which Perfetto (ui.perfetto.dev) and chrome://tracing open.
// Format: "Trace Event Format", Google, 2016 (complete events "X", counters "C", metadata "M"; microseconds).

#include "renderer/frame/frame_report.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace rushlight {

/// When a frame was drawn, by the host's clock in milliseconds, and what only the host can measure of it.
struct FrameTiming {
    double beginMs = 0;  ///< since the trace's start
    double wallMs = 0;
    uint64_t allocations = 0;
    bool warmUp = false;
};

/// One process with the tracks "CPU" (frame > build, execute > passes) and "GPU" (frame > passes), and counters.
/// A report knows how long its parts took, not when they began: they are laid one after another, without gaps, from the
/// start of what holds them. Events of a track nest exactly, in whole nanoseconds. What has no GPU time is not on the
/// GPU's track. The GPU's times are those of the report: of the newest frame that was finished when this one was submitted.
class FrameTrace {
public:
    /// Frames come in order; one that begins before the one before it has ended is moved behind it.
    void add(const FrameReport& report, const FrameTiming& timing);

    /// Why there are no more frames, for the file's metadata.
    void setError(std::string_view text) { error_ = text; }

    uint32_t frames() const { return frames_; }

    /// The whole file: valid after any number of frames. `device` and `version` as the renderer tells them.
    std::string json(std::string_view device, std::string_view version) const;

private:
    std::string events_;  ///< one a line, each with a comma before it
    std::string error_;
    int64_t cpuEnd_ = 0, gpuEnd_ = 0;  ///< nanoseconds
    uint32_t frames_ = 0;
};

}  // namespace rushlight

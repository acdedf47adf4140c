#pragma once
// --trace: the timeline of all frames that a command draws, written when the command ends, however
// it ends.

#include "renderer/capture/frame_trace.h"
#include "sandbox/tool/render_setup.h"
#include "sandbox/tool/stats.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <string>

namespace rushlight::tool {

void addTraceOption(CLI::App& command, std::string& path);

/// Without a path it does nothing.
class TraceFile {
public:
    explicit TraceFile(const std::string& path) : path_(path) {}

    /// An Error where no file can be written there; to be asked before anything is drawn.
    Result<void> check() const;

    /// A frame that has just been drawn.
    void add(const FrameReport& report, const FrameTimes& times, bool warmUp);

    /// Writes the file. `outcome` is what the command ends with: its Error goes into the file and
    /// on to the caller.
    Result<void> finish(Result<void> outcome, RenderSetup& setup);

private:
    using Clock = std::chrono::steady_clock;

    std::string path_;
    FrameTrace trace_;
    Clock::time_point start_ = Clock::now();
};

}  // namespace rushlight::tool

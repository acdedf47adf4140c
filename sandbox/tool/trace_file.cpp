#include "sandbox/tool/trace_file.h"

#include "renderer/capture/write_file.h"

namespace rushlight::tool {

void addTraceOption(CLI::App& command, std::string& path) {
    command.add_option(
        "--trace", path,
        "Write the timeline of all frames drawn, for Perfetto or chrome://tracing, into "
        "this .json file");
}

Result<void> TraceFile::check() const {
    if (path_.empty()) return {};
    return writeFile(path_, FrameTrace().json({}, {}));
}

void TraceFile::add(const FrameReport& report, const FrameTimes& times, bool warmUp) {
    if (path_.empty()) return;
    const std::chrono::duration<double, std::milli> now = Clock::now() - start_;
    trace_.add(report, {now.count() - times.wallMs, times.wallMs, times.allocations, warmUp});
}

Result<void> TraceFile::finish(Result<void> outcome, RenderSetup& setup) {
    if (path_.empty()) return outcome;
    if (!outcome) trace_.setError(outcome.error().text());
    const Renderer& renderer = setup.renderer();
    const Result<void> written = writeFile(
        path_, trace_.json(renderer.deviceName(), renderer.deviceVersion()));
    return outcome ? written : outcome;
}

}  // namespace rushlight::tool

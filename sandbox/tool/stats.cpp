#include "sandbox/tool/stats.h"

#include "renderer/capture/report_json.h"
#include "renderer/capture/write_file.h"

#include <sys/resource.h>
#include <nlohmann/json.hpp>

namespace rushlight::tool {
namespace {

using nlohmann::ordered_json;

double peakMemoryMb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) / 1024;
}

ordered_json measuredFrame(const FrameReport& report, const FrameTimes& times) {
    ordered_json frame = frameJson(report);
    frame["wall_ms"] = times.wallMs;
    frame["allocations"] = times.allocations;
    return frame;
}

}  // namespace

ordered_json statsJson(RenderSetup& setup, uvec2 size, double firstFrameMs,
                       const FrameReport& report, const FrameTimes& times) {
    const assets::Fidelity& fidelity = setup.fidelity();
    return {{"version", 1},
            {"context", toText(setup.contextKind())},
            {"gl_renderer", std::string(setup.renderer().deviceName())},
            {"gl_version", std::string(setup.renderer().deviceVersion())},
            {"size", {size.x, size.y}},
            {"threads", setup.threads()},
            {"load_ms", setup.loadMs()},
            {"first_frame_ms", firstFrameMs},
            {"peak_rss_mb", peakMemoryMb()},
            {"frame", measuredFrame(report, times)},
            {"passes", passesJson(report)},
            {"fidelity",
             {{"exact", fidelity.exact},
              {"approximated", fidelity.approximated},
              {"unsupported", fidelity.unsupported}}}};
}

Result<void> writeJson(const std::string& path, const ordered_json& json) {
    // Names come from files and may be no UTF-8.
    return writeFile(path, json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace rushlight::tool

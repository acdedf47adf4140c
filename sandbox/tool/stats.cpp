#include "sandbox/tool/stats.h"

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

ordered_json frameJson(const FrameReport& r, const FrameTimes& times) {
    return {{"cpu_build_ms", r.cpuBuildMs},
            {"cpu_execute_ms", r.cpuExecuteMs},
            {"gpu_ms", r.gpuMs},
            {"wall_ms", times.wallMs},
            {"instances", r.instances},
            {"visible", r.visible},
            {"culled_frustum", r.culledFrustum},
            {"culled_occlusion", r.culledOcclusion},
            {"culled_small", r.culledSmall},
            {"rejected", r.rejected},
            {"draws", r.draws},
            {"triangles", r.triangles},
            {"gl_calls", r.glCalls},
            {"state_changes", r.stateChanges},
            {"uploaded_bytes", r.uploadedBytes},
            {"allocations", times.allocations},
            {"lights", r.lights},
            {"lights_visible", r.lightsVisible},
            {"shadow_views_drawn", r.shadowViewsDrawn},
            {"shadow_views_cached", r.shadowViewsCached},
            {"shadow_lights", r.shadowLights},
            {"shadow_lights_reduced", r.shadowLightsReduced},
            {"shadow_lights_without", r.shadowLightsWithout},
            {"waits", r.waits},
            {"queue_waits", r.queueWaits}};
}

ordered_json passesJson(const FrameReport& report) {
    ordered_json passes = ordered_json::array();
    for (const PassReport& pass : report.passes)
        passes.push_back({{"name", pass.name},
                          {"draws", pass.draws},
                          {"triangles", pass.triangles},
                          {"cpu_ms", pass.cpuMs},
                          {"gpu_ms", pass.gpuMs},
                          {"reads", pass.reads},
                          {"writes", pass.writes},
                          {"bytes_per_pixel", pass.bytesPerPixel}});
    return passes;
}

}  // namespace

ordered_json statsJson(RenderSetup& setup, uvec2 size, double firstFrameMs, const FrameReport& report,
                       const FrameTimes& times) {
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
            {"frame", frameJson(report, times)},
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

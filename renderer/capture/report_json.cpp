#include "renderer/capture/report_json.h"

#include <nlohmann/json.hpp>

namespace rushlight {

using nlohmann::ordered_json;

ordered_json frameJson(const FrameReport& r) {
    return {{"cpu_build_ms", r.cpuBuildMs},
            {"cpu_execute_ms", r.cpuExecuteMs},
            {"gpu_ms", r.gpuMs},
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
            {"lights", r.lights},
            {"lights_visible", r.lightsVisible},
            {"shadow_views_drawn", r.shadowViewsDrawn},
            {"shadow_views_cached", r.shadowViewsCached},
            {"shadow_lights", r.shadowLights},
            {"shadow_lights_reduced", r.shadowLightsReduced},
            {"shadow_lights_without", r.shadowLightsWithout},
            {"waits", r.waits},
            {"queue_waits", r.queueWaits},
            {"pipelines_compiled", r.pipelinesCompiled}};
}

ordered_json passesJson(const FrameReport& report) {
    ordered_json passes = ordered_json::array();
    for (const PassReport& pass : report.passes)
        passes.push_back({{"name", pass.name},
                          {"draws", pass.draws},
                          {"triangles", pass.triangles},
                          {"gl_calls", pass.glCalls},
                          {"state_changes", pass.stateChanges},
                          {"cpu_ms", pass.cpuMs},
                          {"gpu_ms", pass.gpuMs},
                          {"reads", pass.reads},
                          {"writes", pass.writes},
                          {"bytes_per_pixel", pass.bytesPerPixel}});
    return passes;
}

}  // namespace rushlight

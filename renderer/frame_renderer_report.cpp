#include "renderer/frame_renderer.h"

namespace rushlight {
namespace {

// What falls off the end waits in `spare`, so that frames with now more, now fewer passes make no allocations.
void resizeKeepingMemory(std::vector<PassReport>& reports, std::vector<PassReport>& spare,
                         size_t count) {
    while (reports.size() > count) {
        spare.push_back(std::move(reports.back()));
        reports.pop_back();
    }
    while (reports.size() < count) {
        if (spare.empty()) spare.emplace_back();
        reports.push_back(std::move(spare.back()));
        spare.pop_back();
    }
}

}  // namespace

void FrameRenderer::fillReport(const FrameInput& input) {
    FrameReport& r = report_;
    r.frameNumber = frameNumber_;
    r.instances = uint32_t(input.instances.size());
    r.visible = opaque_.visibleCount() + blended_.visibleCount();
    r.rejected = 0;
    for (const ResolvedInstance& resolved : resolved_) r.rejected += !resolved.mesh;
    r.culledFrustum = r.instances - r.rejected - r.visible;
    r.lights = uint32_t(input.lighting.directional.size() + input.lighting.punctual.size());
    r.lightsVisible = uint32_t(input.lighting.directional.size()) + clusters_.visibleLights;
    r.shadowViewsDrawn = shadows_.drawn;
    r.shadowViewsCached = shadows_.cached;
    r.cpuExecuteMs = execution_.cpuMs;
    r.glCalls = execution_.glCalls;
    r.stateChanges = execution_.stateChanges;
    r.uploadedBytes = execution_.uploadedBytes;
    r.waits = execution_.waits;
    r.draws = 0;
    r.triangles = 0;
    r.gpuMs = 0;
    resizeKeepingMemory(r.passes, sparePassReports_, plan_.keptPassCount());
    for (uint32_t i = 0; i < plan_.keptPassCount(); ++i) {
        PassReport& pass = r.passes[i];
        const PassExecution& done = execution_.passes[i];
        pass.name = plan_.passName(i);
        pass.draws = done.draws;
        pass.triangles = done.triangles;
        pass.cpuMs = done.cpuMs;
        pass.gpuMs = done.gpuMs;
        pass.hashes.assign(done.attachmentHashes.begin(), done.attachmentHashes.end());
        pass.bytesPerPixel = plan_.passBytesPerPixel(i);
        pass.reads.clear();
        pass.writes.clear();
        plan_.forEachRead(i, [&](const char* name) { pass.reads.push_back(name); });
        plan_.forEachWrite(i, [&](const char* name) { pass.writes.push_back(name); });
        r.draws += done.draws;
        r.triangles += done.triangles;
        r.gpuMs += done.gpuMs;
    }
    if (r.rejected > 0 && !warnedRejected_) {
        warnedRejected_ = true;
        log_(LogLevel::warning,
             std::to_string(r.rejected) +
                 " instances are left out: their mesh or material handle is stale, their "
                 "previous transform is missing, or their transform is not finite.");
    }
}

}  // namespace rushlight

#include "renderer/pipeline/frame_reporter.h"

#include <algorithm>
#include <chrono>

namespace rushlight {
namespace {

double millisecondsBetween(std::chrono::steady_clock::time_point from,
                           std::chrono::steady_clock::time_point to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
}

// What falls off the end waits in `spare`, so that frames with now more, now fewer passes make no
// allocations.
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

// They are large and rare: where a frame has none, none are kept.
void takeTexels(const ReadbackImage* image, std::vector<std::byte>& texels) {
    if (image)
        texels = image->bytes;
    else
        std::vector<std::byte>().swap(texels);
}

}  // namespace

void FrameReporter::noteBuilt(const Built& built) {
    FrameReport& r = report_;
    r.frameNumber = built.frame;
    r.instances = r.rejected = 0;
    for (const InstanceWorld* world : built.worlds->worlds)
        if (world) {
            r.instances += world->count();
            r.rejected += world->rejected();
        }
    r.visible = built.visibility.visible;
    r.culledSmall = built.visibility.culledSmall;
    r.culledOcclusion = built.visibility.culledOcclusion;
    r.culledFrustum = r.instances - r.rejected - r.visible - r.culledSmall - r.culledOcclusion;
    const Lighting& l = built.input->lighting;
    r.lights = uint32_t(l.directional.size() + l.punctual.size() + l.area.size());
    r.lightsVisible = uint32_t(l.directional.size()) + built.lightsVisible;
    r.pipelinesCompiled = uint32_t(built.compiledPrograms - compiledPrograms_);
    compiledPrograms_ = built.compiledPrograms;
    const ShadowStage::Outputs& shadows = *built.shadows;
    r.shadowViewsDrawn = shadows.drawn;
    r.shadowViewsCached = shadows.cached;
    r.shadowLights = shadows.lights.lights;
    r.shadowLightsReduced = shadows.lights.reduced;
    r.shadowLightsWithout = shadows.lights.without;
    if (r.rejected > 0 && !warnedRejected_) {
        warnedRejected_ = true;
        log_(LogLevel::warning,
             std::to_string(r.rejected) +
                 " instances are left out: their mesh or material handle is stale, their "
                 "previous transform is missing, or their transform is not finite.");
    }
}

std::vector<InstanceFacts> describeInstances(const Stores& stores, const ViewState& view) {
    std::vector<InstanceFacts> all;
    const std::array worlds = {stores.worlds.find(view.lastWorld()), &view.instances};
    for (uint32_t w = 0; w < worlds.size(); ++w) {
        const InstanceWorld* world = worlds[w];
        if (!world) continue;
        world->forEach([&](uint32_t slot, const InstanceRecord& record) {
            InstanceFacts& facts = all.emplace_back();
            facts.instance = {record.worldFromLocal, record.mesh,
                              record.material,       record.id,
                              record.instanceFlags,  record.previousTransform};
            facts.kept = w == 0;
            facts.index = slot;
            facts.rejected = !record.valid;
            facts.staleMaterial = !stores.materials.find(record.material);
            facts.bounds = record.box;
            const GpuMesh* mesh = stores.geometry.find(record.mesh);
            facts.staleMesh = !mesh;
            facts.notFinite = facts.rejected && mesh && !facts.staleMaterial;
            if (!mesh) return;
            facts.lodCount = uint8_t(mesh->lodCount);
            const uint32_t lod = view.lods.last(FrameWorlds::object(w, slot), record.stamp);
            facts.lod = uint8_t(std::min(lod, mesh->lodCount - 1));
            facts.triangles = mesh->lods[facts.lod].indexCount / 3;
            facts.closed = mesh->closed;
        });
    }
    return all;
}

void FrameReporter::describePasses(const FramePlan& plan, SubmittedFrame& frame) {
    resizeKeepingMemory(frame.passes, frame.sparePasses, plan.keptPassCount());
    for (uint32_t i = 0; i < plan.keptPassCount(); ++i) {
        PassReport& pass = frame.passes[i];
        pass.name = plan.passName(i);
        pass.bytesPerPixel = plan.passBytesPerPixel(i);
        pass.reads.clear();
        pass.writes.clear();
        plan.forEachRead(i, [&](const char* name) { pass.reads.push_back(name); });
        pass.images.clear();
        plan.forEachWrite(i, [&](const PassImage& image) {
            pass.writes.push_back(image.name);
            pass.images.push_back(image);
        });
    }
}

const FrameReport& FrameReporter::report(const SubmittedFrame* frame) {
    FrameReport& r = report_;
    if (!frame) return r;
    const ExecutionReport& execution = frame->execution;
    r.executedFrame = frame->frameNumber;
    r.cpuExecuteBeginMs = millisecondsBetween(frame->began, execution.began);
    r.cpuExecuteMs = execution.cpuMs;
    r.gpuFrame = execution.gpuFrame;
    r.glCalls = execution.glCalls;
    r.stateChanges = execution.stateChanges;
    r.uploadedBytes = execution.uploadedBytes;
    r.waits = execution.waits;
    r.queueWaits = execution.queueWaits;
    r.synchronousCalls = execution.synchronousCalls;
    r.draws = 0;
    r.triangles = 0;
    r.gpuMs = 0;
    resizeKeepingMemory(r.passes, sparePasses_, frame->passes.size());
    for (size_t i = 0; i < frame->passes.size(); ++i) {
        PassReport& pass = r.passes[i];
        static const PassExecution kNotExecuted;  // the device was lost
        const PassExecution& done = i < execution.passes.size() ? execution.passes[i]
                                                                : kNotExecuted;
        pass = frame->passes[i];
        pass.draws = done.draws;
        pass.triangles = done.triangles;
        pass.glCalls = done.glCalls;
        pass.stateChanges = done.stateChanges;
        pass.cpuBeginMs = done.cpuBeginMs;
        pass.cpuMs = done.cpuMs;
        pass.gpuBeginMs = done.gpuBeginMs;
        pass.gpuMs = done.gpuMs;
        pass.hashes.assign(done.attachmentHashes.begin(), done.attachmentHashes.end());
        for (size_t k = 0; k < pass.images.size(); ++k)
            takeTexels(k < done.attachments.size() ? &done.attachments[k] : nullptr,
                       pass.images[k].texels);
        r.draws += done.draws;
        r.triangles += done.triangles;
        r.gpuMs += done.gpuMs;
    }
    return r;
}

}  // namespace rushlight

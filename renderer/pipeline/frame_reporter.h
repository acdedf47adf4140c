#pragma once
// What frames did: known in part when they are built, in full when they were executed.

#include "engine/core/log.h"
#include "renderer/frame/frame_report.h"
#include "renderer/frame/instance_facts.h"
#include "renderer/pipeline/stages/lighting_stage.h"
#include "renderer/pipeline/submitted_frames.h"

#include <vector>

namespace rushlight {

class FrameReporter {
public:
    /// What a built frame counted.
    struct Built {
        uint64_t frame = 0;
        const FrameInput* input = nullptr;
        const FrameWorlds* worlds = nullptr;
        Visibility::Counts visibility;
        const ShadowStage::Outputs* shadows = nullptr;
        uint32_t lightsVisible = 0;     ///< of those in froxels
        uint64_t compiledPrograms = 0;  ///< Device::compiledPrograms()
    };

    explicit FrameReporter(LogSink log) : log_(log) {}
    void noteBuilt(const Built& built);
    void noteBuildTime(double milliseconds) { report_.cpuBuildMs = milliseconds; }
    /// The passes of a plan that is about to be executed.
    static void describePasses(const FramePlan& plan, SubmittedFrame& frame);
    /// `executed` is the newest frame that is; null before the first.
    const FrameReport& report(const SubmittedFrame* executed);

private:
    LogSink log_;
    FrameReport report_;
    std::vector<PassReport> sparePasses_;
    uint64_t compiledPrograms_ = 0;  ///< when the frame before was built
    bool warnedRejected_ = false;
};

/// All instances of a view's last frame, the kept world's first.
std::vector<InstanceFacts> describeInstances(const Stores& stores, const ViewState& view);

}  // namespace rushlight

#pragma once
// One frame, told in chapters: check, scene, visibility, plan, record, execute, report.

#include "renderer/frame/frame_options.h"
#include "renderer/pipeline/draw_list_filler.h"
#include "renderer/pipeline/frame_reporter.h"
#include "renderer/pipeline/stages/blend_stage.h"
#include "renderer/pipeline/stages/debug_stage.h"
#include "renderer/pipeline/stages/post_stage.h"
#include "renderer/rhi/commands/validate_commands.h"

#include <memory>

namespace rushlight {

/// What a frame is made by, in the order of the frame.
struct FrameStages {
    explicit FrameStages(Device& device)
        : shadow(device),
          surface(device),
          lighting(device),
          screen(device),
          blend(device),
          post(device),
          debug(device) {}

    ShadowStage shadow;
    SurfaceStage surface;
    LightingStage lighting;
    ScreenStage screen;
    BlendStage blend;
    PostStage post;
    DebugStage debug;
};

class FramePipeline {
public:
    FramePipeline(Device& device, JobSystem& jobs, LogSink log, std::string cacheDirectory);

    Stores stores;

    Result<void> createMeshes(std::span<const MeshDesc> meshes, std::span<MeshHandle> handles) {
        return stores.geometry.create(meshes, handles, jobs_);
    }
    ViewHandle createView();
    void destroy(ViewHandle view) { views_.erase(view); }

    /// `capture` is null for a frame into the host's framebuffer. After an Error the view remembers
    /// what it remembered before.
    Result<void> render(const FrameInput& input, const FrameTarget& target,
                        const CaptureRequest* capture, const FrameOptions& options);
    /// Shaders changed: no image that a view keeps is good any more.
    void forgetImages();
    void setValidation(bool on) { validates_ = on; }

    const FrameReport& report();
    std::vector<InstanceFacts> describeInstances() const;
    const CommandBuffer& commands() const { return submitted_.newestCommands(); }

private:
    struct Plan;  ///< what planning one frame gave
    ViewState* findView(ViewHandle handle);
    Result<void> flushResources();
    FrameWorlds prepareWorlds(const FrameInput& input, ViewState& view);
    Visibility::Counts gatherVisible(FrameContext& frame, const ShadowStage::Views& views);
    Result<Plan> plan(FrameContext& frame, const ShadowStage::Views& views);
    Result<void> planPicture(FrameContext& frame, const DebugStage::Inputs& made, ImageId radiance,
                             Plan& plan);
    Result<void> present(FrameContext& frame, const DebugStage::Inputs& made, ImageId radiance);
    Result<void> build(FrameContext& frame, uint64_t passOrderSeed);
    Result<void> execute(FrameContext& frame, const FrameOptions& options,
                         std::chrono::steady_clock::time_point began);
    Result<void> validateCommands();
    Result<void> checkExecuted();

    Device& device_;
    JobSystem& jobs_;
    LogSink log_;
    FrameStages stages_;
    FramePlan plan_;
    Visibility visibility_;
    Visibility::Lists lists_;
    DrawListFiller filler_;
    std::vector<DrawList*> drawn_;
    CommandBuffer commands_;
    CommandValidator validator_;
    bool validates_ = false;
    SubmittedFrames submitted_;
    FrameReporter reporter_;
    ViewState defaultView_;
    Pool<std::unique_ptr<ViewState>, ViewTag> views_;
    ViewHandle lastView_;
    uint64_t frameNumber_ = 0;
};

}  // namespace rushlight

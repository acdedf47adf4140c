#include "renderer/pipeline/frame_pipeline.h"

#include "renderer/pipeline/debug_views.h"
#include "renderer/pipeline/frame_checks.h"
#include "renderer/replay/snapshot.h"
#include "renderer/rhi/saved/frame_file.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace rushlight {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

struct FramePipeline::Plan {
    ShadowStage::Outputs shadows;
    uint32_t lightsVisible = 0;
    ImageId captured;  ///< read back; null for a frame into the host's framebuffer
};

FramePipeline::FramePipeline(Device& device, JobSystem& jobs, LogSink log,
                             std::string cacheDirectory)
    : stores(device, jobs, log, std::move(cacheDirectory)),
      device_(device),
      jobs_(jobs),
      log_(log),
      stages_(device),
      plan_(device),
      submitted_(device.maxPendingFrames()),
      reporter_(log),
      defaultView_(device) {}

ViewHandle FramePipeline::createView() {
    return views_.insert(std::make_unique<ViewState>(device_));
}

ViewState* FramePipeline::findView(ViewHandle handle) {
    if (!handle) return &defaultView_;
    std::unique_ptr<ViewState>* view = views_.find(handle);
    return view ? view->get() : nullptr;
}

void FramePipeline::forgetImages() {
    defaultView_.forgetImages();
    views_.forEach([](ViewHandle, std::unique_ptr<ViewState>& view) { view->forgetImages(); });
}

Result<void> FramePipeline::render(const FrameInput& input, const FrameTarget& target,
                                   const CaptureRequest* capture, const FrameOptions& options) {
    const auto start = Clock::now();
    if (auto ok = device_.status(); !ok) return ok;
    if (auto ok = checkExecuted(); !ok) return ok;  // of a frame that another thread executed
    if (auto ok = checkFrame(input, target, stores); !ok) return ok;
    ViewState* view = findView(input.view.state);
    if (!view) return fail("view", "its state is a stale handle.", ErrorKind::wrongUse);
    auto camera = makeCamera(input.view, float(target.width) / float(target.height));
    if (!camera) return tl::unexpected(camera.error());
    if (auto ok = flushResources(); !ok) return ok;

    commands_.clear();
    plan_.begin();
    drawn_.clear();
    const FrameWorlds worlds = prepareWorlds(input, *view);
    if (view->last().frames > 0 && !input.settings.cut)
        camera->previousClipFromWorld = view->last().clipFromWorld;
    view->next.clipFromWorld = camera->clipFromWorld;
    jitterCamera(*camera, input.view.jitter, target.width, target.height);
    lastView_ = input.view.state;
    FrameContext frame{input, target,    capture, *camera, stores, jobs_,
                       plan_, commands_, *view,   worlds,  drawn_};
    if (auto ok = build(frame, options.passOrderSeed); !ok) return ok;
    reporter_.noteBuildTime(millisecondsSince(start));
    if (validates_)
        if (auto ok = validateCommands(); !ok) return ok;
    if (options.savedFrame)
        *options.savedFrame = encodeFrame(takeSnapshot(device_, commands_, target));
    return execute(frame, options, start);
}

Result<void> FramePipeline::flushResources() {
    const auto moved = stores.textures.flush();
    if (!moved) return tl::unexpected(moved.error());
    return stores.materials.flush(*moved);
}

FrameWorlds FramePipeline::prepareWorlds(const FrameInput& input, ViewState& view) {
    GeometryStore& geometry = stores.geometry;
    MaterialStore& materials = stores.materials;
    InstanceWorld* kept = stores.worlds.find(input.world);
    uint64_t oldest = ViewMotion::kAll;
    const auto note = [&](InstanceWorld& world) {
        world.noteChanges(geometry.changedMeshes(), materials.changedMaterials());
    };
    const auto noteView = [&](ViewState& state) {
        note(state.instances);
        oldest = std::min(oldest, state.motion.seenOf(input.world));
    };
    noteView(defaultView_);
    views_.forEach([&](ViewHandle, std::unique_ptr<ViewState>& state) { noteView(*state); });
    stores.worlds.forEach(note);
    visibility_.noteChanges(geometry.changedMeshes());
    geometry.clearChanges();
    materials.clearChanges();
    if (kept) {
        kept->forgetMoves(oldest);
        kept->prepare(geometry, materials, {}, jobs_);
    }
    view.beginFrame(input.world, kept);
    view.instances.assign(input.instances, jobs_);
    view.instances.prepare(geometry, materials, input.previousTransforms, jobs_);
    return {{kept, &view.instances}, &view.motion};
}

Visibility::Counts FramePipeline::gatherVisible(FrameContext& frame,
                                                const ShadowStage::Views& views) {
    Visibility::Inputs in;
    in.worlds = frame.worlds;
    in.geometry = &stores.geometry;
    in.camera = &frame.camera;
    in.targetWidth = frame.width();
    in.targetHeight = frame.height();
    in.settings = &frame.settings();
    in.cascades = views.cascades;
    in.lods = &frame.view.lods;
    return visibility_.gather(in, jobs_, lists_);
}

Result<void> FramePipeline::build(FrameContext& frame, uint64_t passOrderSeed) {
    const ShadowStage::Views views = stages_.shadow.chooseViews(frame);
    const Visibility::Counts visible = gatherVisible(frame, views);
    const auto planned = plan(frame, views);
    if (!planned) return tl::unexpected(planned.error());
    if (auto ok = plan_.compile(passOrderSeed); !ok) return ok;
    filler_.fill(drawn_, frame.worlds, commands_, jobs_);
    plan_.record(jobs_, commands_);
    if (frame.capture)
        commands_.push(Readback{plan_.texture(planned->captured), 0, 0, frame.capture->ticket});
    reporter_.noteBuilt({frameNumber_, &frame.input, &frame.worlds, visible, &planned->shadows,
                         planned->lightsVisible, device_.compiledPrograms()});
    return {};
}

Result<FramePipeline::Plan> FramePipeline::plan(FrameContext& frame,
                                                const ShadowStage::Views& views) {
    if (const char* image = debugViewRow(frame.settings().debugView).image) plan_.want(image);
    const auto shadows = stages_.shadow.add(frame, {views, &lists_});
    if (!shadows) return tl::unexpected(shadows.error());
    const auto surface = stages_.surface.add(frame, {&lists_});
    if (!surface) return tl::unexpected(surface.error());
    const auto lit = stages_.lighting.add(frame, {&*surface, &views, &*shadows});
    if (!lit) return tl::unexpected(lit.error());
    const auto screen = stages_.screen.add(frame, {&surface->gbuffer, &*lit});
    if (!screen) return tl::unexpected(screen.error());
    const auto blended = stages_.blend.add(frame, {&lists_, &*surface, &*lit, &*screen});
    if (!blended) return tl::unexpected(blended.error());

    Plan plan{*shadows, lit->clusters->visibleLights, {}};
    const DebugStage::Inputs made{&lists_, &*surface, &*shadows, &*lit, {}};
    if (auto ok = planPicture(frame, made, blended->radiance, plan); !ok)
        return tl::unexpected(ok.error());
    return plan;
}

Result<void> FramePipeline::planPicture(FrameContext& frame, const DebugStage::Inputs& made,
                                        ImageId radiance, Plan& plan) {
    const DebugViewRow& row = debugViewRow(frame.settings().debugView);
    DebugStage::Inputs in = made;
    in.target = {{}, frame.width(), frame.height(), frame.target.topRowFirst};
    if (frame.capture && frame.capture->kind == CaptureKind::hdr) {
        plan.captured = radiance;
        if (row.presentation == Presentation::scattered)
            if (auto ok = stages_.post.scatter(frame, frame.settings(), radiance); !ok)
                return tl::unexpected(ok.error());
        if (row.linear) plan.captured = plan_.find(row.image);
        plan_.requestImage(plan.captured);
        return {};
    }
    if (frame.capture) {
        plan.captured = plan_.createImage({"frame", Format::rgba8, frame.width(), frame.height()});
        plan_.requestImage(plan.captured);
        in.target.image = plan.captured;
    }
    if (auto ok = present(frame, in, radiance); !ok) return ok;
    return stages_.debug.addOverlay(frame, in.target);
}

Result<void> FramePipeline::present(FrameContext& frame, const DebugStage::Inputs& made,
                                    ImageId radiance) {
    const DebugView view = frame.settings().debugView;
    const DebugViewRow& row = debugViewRow(view);
    if (row.presentation == Presentation::channel)
        return stages_.debug.addChannel(frame, made, view);
    const FrameSettings settings = presentedSettings(frame.settings(), row.presentation);
    const bool replaces = row.image && row.presentation != Presentation::scattered;
    PostStage::DisplayInputs in;
    in.radiance = replaces ? plan_.find(row.image) : radiance;
    in.settings = &settings;
    in.target = made.target;
    const auto scattered = stages_.post.scatter(frame, settings, in.radiance);
    if (!scattered) return tl::unexpected(scattered.error());
    in.scattered = *scattered;
    if (row.presentation == Presentation::scattered) {
        in.radiance = plan_.find(row.image);
        in.scattered.bloom = {};
    }
    if (auto ok = stages_.post.display(frame, in); !ok) return ok;
    if (row.presentation != Presentation::frameAndBoxes) return {};
    return stages_.debug.addBounds(frame, made);
}

Result<void> FramePipeline::validateCommands() {
    // In one step, as it asks for many descriptions.
    const std::vector<Error>* found = nullptr;
    const auto validate = [&] { found = &validator_.validate(commands_, device_); };
    device_.runInOrder([](void* f) { (*static_cast<decltype(validate)*>(f))(); },
                       const_cast<void*>(static_cast<const void*>(&validate)));
    const std::vector<Error>& faults = *found;
    if (faults.empty()) return {};
    for (const Error& fault : faults) log_(LogLevel::error, fault.text());
    return tl::unexpected(faults[0]);
}

Result<void> FramePipeline::execute(FrameContext& frame, const FrameOptions& options,
                                    Clock::time_point began) {
    ExecuteOptions execute;
    execute.target = frame.target;
    execute.frame = frameNumber_;
    execute.hashAttachments = options.hashPasses;
    execute.keepAttachments = options.keepImages;
    execute.timers = options.timers;
    execute.toHost = !frame.capture;
    SubmittedFrame& submitted = submitted_.add(commands_);
    submitted.began = began;
    submitted.frameNumber = frameNumber_++;
    FrameReporter::describePasses(plan_, submitted);
    device_.execute(submitted.commands, execute, submitted.execution);
    report();
    // Where another thread executes it, it is taken to be executed until it is known to have
    // failed.
    if (device_.maxPendingFrames() == 0)
        if (auto ok = checkExecuted(); !ok) return ok;
    frame.view.commit();
    return {};
}

// Who knows what a frame that failed has drawn.
Result<void> FramePipeline::checkExecuted() {
    const Result<void> failure = device_.takeFailure();
    if (!failure) forgetImages();
    return failure;
}

const FrameReport& FramePipeline::report() {
    return reporter_.report(submitted_.newestExecuted(device_.pendingFrames()));
}

std::vector<InstanceFacts> FramePipeline::describeInstances() const {
    const std::unique_ptr<ViewState>* view = views_.find(lastView_);
    return rushlight::describeInstances(stores, view ? **view : defaultView_);
}

}  // namespace rushlight

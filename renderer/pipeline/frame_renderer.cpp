#include "renderer/pipeline/frame_renderer.h"

#include "renderer/pipeline/lighting_uniforms.h"
#include "renderer/replay/snapshot.h"
#include "renderer/rhi/saved/frame_file.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace rushlight {
namespace {

double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

SamplerHandle clampingSampler(Device& device, bool mipmaps) {
    SamplerDesc desc;
    desc.wrapU = desc.wrapV = TextureWrap::clampToEdge;
    desc.useMipmaps = mipmaps;
    return device.createSampler(desc);
}

}  // namespace

FrameRenderer::FrameRenderer(Device& device, JobSystem& jobs, LogSink log,
                             std::string cacheDirectory)
    : geometry(device),
      textures(device, jobs),
      materials(device, textures),
      decals(device),
      lightPatterns(device),
      environments(device, jobs, log, std::move(cacheDirectory)),
      reflections(device, environments),
      irradianceVolumes(device),
      device_(device),
      jobs_(jobs),
      log_(log),
      plan_(device),
      gbufferPass_(device),
      gtaoPass_(device),
      pyramidPass_(device),
      reflectionsPass_(device),
      shadowPass_(device),
      shadowAtlasPass_(device),
      shadowGlassPass_(device),
      irradiancePass_(device),
      lightingPass_(device),
      fogPass_(device),
      forwardPass_(device),
      bloomPass_(device),
      exposurePass_(device),
      tonemapPass_(device),
      fxaaPass_(device),
      debugViewPass_(device),
      boundsPass_(device),
      overdrawPass_(device),
      overlayPass_(device),
      shadowSampler_(nearestClampSampler(device)),
      cubeSampler_(clampingSampler(device, true)),
      linearSampler_(clampingSampler(device, false)),
      decalSampler_(clampingSampler(device, true)),
      submitted_(device.maxPendingFrames()) {}

Result<void> FrameRenderer::render(const FrameInput& input, const FrameOutput& output,
                                   const FrameOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    if (auto ok = device_.status(); !ok) return ok;
    if (auto ok = checkExecuted(); !ok) return ok;  // of a frame that another thread executed
    if (auto ok = checkInput(input, output); !ok) return ok;
    const float aspect = float(output.target.width) / float(output.target.height);
    const auto camera = makeCamera(input.view, aspect);
    if (!camera) return tl::unexpected(camera.error());
    if (auto ok = prepareResources(); !ok) return ok;

    commands_.clear();
    plan_.begin();
    prepareWorlds(input);
    gatherViews(input, output, *camera);
    planLightShadows(input, output, *camera);
    auto planned = planPasses(input, output, *camera);
    if (planned) planned = plan_.compile();
    if (!planned) {
        forgetCaches();  // what was planned is not drawn
        return planned;
    }
    fillLists();
    plan_.record(jobs_, commands_);
    if (output.offscreen)
        commands_.push(Readback{plan_.texture(capturedImage_), 0, 0, output.ticket});
    report_.cpuBuildMs = millisecondsSince(start);
    if (validates_)
        if (auto ok = validateCommands(); !ok) return ok;
    if (options.savedFrame)
        *options.savedFrame = encodeFrame(takeSnapshot(device_, commands_, output.target));

    ExecuteOptions execute;
    execute.target = output.target;
    execute.frame = frameNumber_;
    execute.hashAttachments = options.hashPasses;
    execute.keepAttachments = options.keepImages;
    execute.timers = options.timers;
    execute.toHost = !output.offscreen;
    SubmittedFrame& frame = submitted_.add(commands_);
    frame.began = start;
    describePasses(frame);
    device_.execute(frame.commands, execute, frame.execution);
    fillReport(input);
    report();
    ++frameNumber_;
    return device_.maxPendingFrames() == 0 ? checkExecuted() : Result<void>();
}

Result<void> FrameRenderer::checkExecuted() {
    const Result<void> failure = device_.takeFailure();
    if (!failure) forgetCaches();  // who knows what was drawn
    return failure;
}

Result<void> FrameRenderer::validateCommands() {
    // In one step, as it asks for many descriptions.
    const std::vector<Error>* found = nullptr;
    const auto validate = [&] { found = &validator_.validate(commands_, device_); };
    device_.runInOrder([](void* f) { (*static_cast<decltype(validate)*>(f))(); },
                       const_cast<void*>(static_cast<const void*>(&validate)));
    const std::vector<Error>& faults = *found;
    if (faults.empty()) return {};
    for (const Error& fault : faults) log_(LogLevel::error, fault.text());
    forgetCaches();  // what was planned is not drawn
    return tl::unexpected(faults[0]);
}

Result<void> FrameRenderer::prepareResources() {
    const auto moved = textures.flush();
    if (!moved) return tl::unexpected(moved.error());
    return materials.flush(*moved);
}

void FrameRenderer::prepareWorlds(const FrameInput& input) {
    const auto note = [&](InstanceWorld& world) {
        world.noteChanges(geometry.changedMeshes(), materials.changedMaterials());
    };
    note(frameInstances_);
    worlds.forEach(note);
    visibility_.noteChanges(geometry.changedMeshes());
    geometry.clearChanges();
    materials.clearChanges();
    frameInstances_.assign(input.instances, jobs_);
    frameInstances_.prepare(geometry, materials, input.previousTransforms, jobs_);
    lastWorld_ = input.world;
    frameWorlds_.worlds = {worlds.find(input.world), &frameInstances_};
    if (InstanceWorld* kept = frameWorlds_.worlds[0]) kept->prepare(geometry, materials, {}, jobs_);
}

void FrameRenderer::gatherViews(const FrameInput& input, const FrameOutput& output,
                                const CameraMatrices& camera) {
    planShadows(input, camera);
    Visibility::Inputs in;
    in.worlds = frameWorlds_;
    in.geometry = &geometry;
    in.camera = &camera;
    in.targetWidth = output.target.width;
    in.targetHeight = output.target.height;
    in.settings = &input.settings;
    in.cascades = &cascades_;
    counts_ = visibility_.gather(in, jobs_, lists_);
}

// Writes the instance data of all lists that are drawn.
void FrameRenderer::fillLists() {
    drawnLists_.clear();
    firstFillJobs_.assign(1, 0);
    const auto add = [&](DrawList& list) {
        list.allocate(commands_);
        const uint32_t jobs = uint32_t(list.items.size() + DrawList::kItemsPerJob - 1) /
                              DrawList::kItemsPerJob;
        drawnLists_.push_back(&list);
        firstFillJobs_.push_back(firstFillJobs_.back() + jobs);
    };
    add(lists_.opaque);
    add(lists_.blended);
    add(lists_.movingEmission);
    for (uint32_t i = 0; i < sunViewCount_; ++i)
        if (shadows_.drawnViews >> i & 1) add(*sunViews_[i].casters);
    for (uint32_t i = 0; i < sunViewCount_; ++i)
        if (sunGlass_.drawnViews >> i & 1) add(*sunGlassViews_[i].casters);
    shadowSchedule_.forEachList(add);
    jobs_.forRanges(firstFillJobs_.back(), 1, [&](uint32_t begin, uint32_t end) {
        for (uint32_t job = begin; job < end; ++job) {
            const auto after = std::ranges::upper_bound(firstFillJobs_, job);
            const auto list = size_t(after - firstFillJobs_.begin()) - 1;
            const uint32_t first = (job - firstFillJobs_[list]) * DrawList::kItemsPerJob;
            const uint32_t size = uint32_t(drawnLists_[list]->items.size());
            drawnLists_[list]->fill(commands_, frameWorlds_, first,
                                    std::min(first + DrawList::kItemsPerJob, size));
        }
    });
}

Result<void> FrameRenderer::planPasses(const FrameInput& input, const FrameOutput& output,
                                       const CameraMatrices& camera) {
    const DrawBinder binder{&geometry, &materials};
    const uint32_t width = output.target.width, height = output.target.height;
    interop::ViewUniforms view = makeViewUniforms(camera);
    const DecalBindings decalBindings = bindDecals(input, output, camera, view);
    const BufferRange viewUniforms = uniforms(view);

    auto lighting = bindLighting(input, camera, output);
    if (!lighting) return tl::unexpected(lighting.error());

    if (auto ok = addShadowPasses(input, *lighting); !ok) return ok;

    const ShownImage show = input.settings.show;
    if (show == ShownImage::overdraw && !output.hdr)
        return planOverdraw(input, planTarget(output), camera, viewUniforms);

    auto gbuffer = gbufferPass_.add(
        plan_, {&lists_.opaque, binder, viewUniforms, width, height, decalBindings});
    if (!gbuffer) return tl::unexpected(gbuffer.error());

    const bool sky = lighting->features.environment &&
                     input.lighting.background == Background::environment;
    const auto ambient = planAmbientOcclusion(input, camera, *gbuffer, *lighting, output.target);
    if (!ambient) return tl::unexpected(ambient.error());
    IrradiancePass::Outputs local;
    if (lighting->features.irradianceVolume) {
        const auto irradiance = irradiancePass_.add(plan_, {*gbuffer, *lighting, width, height});
        if (!irradiance) return tl::unexpected(irradiance.error());
        local = *irradiance;
    }
    LightingPass::Inputs lightingInputs{*gbuffer,   *lighting, *ambient, local.tint,
                                        local.flow, sky,       width,    height};
    const ContactShadows contact = input.settings.contactShadows;
    lightingInputs.sunContact = contact != ContactShadows::off && sun_ >= 0;
    lightingInputs.lightContact = contact == ContactShadows::lights &&
                                  lighting->features.punctualShadow;
    lightingInputs.part = lightingPartOf(show);
    const auto lit = lightingPass_.add(plan_, lightingInputs);
    if (!lit) return tl::unexpected(lit.error());
    const auto radiance = planOverLighting(input, camera, lightingInputs, lit->radiance,
                                           viewUniforms, decalBindings);
    if (!radiance) return tl::unexpected(radiance.error());
    if (output.hdr) {
        const auto captured = planLinearCapture(input, output, *radiance, gbuffer->depth);
        if (!captured) return tl::unexpected(captured.error());
        capturedImage_ = *captured;
        plan_.requestImage(capturedImage_);
        return {};
    }
    const FinalTarget target = planTarget(output);
    Result<void> planned = DebugViewPass::shows(show)
                               ? planDebugView(input, target, camera, *gbuffer, *lighting, *ambient)
                               : planDisplay(input, target, *radiance);
    if (!planned) return planned;
    if (show == ShownImage::bounds) {
        planned = boundsPass_.add(
            plan_,
            {{&lists_.opaque, &lists_.blended}, &frameWorlds_, viewUniforms, target, &commands_});
        if (!planned) return planned;
    }
    return overlayPass_.add(
        plan_, {&input.overlay, textures.find(input.overlay.image), target, &commands_});
}

}  // namespace rushlight

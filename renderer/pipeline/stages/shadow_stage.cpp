#include "renderer/pipeline/stages/shadow_stage.h"

#include "renderer/shadows/sun_shadow.h"
#include "renderer/visibility/caster.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace rushlight {
namespace {

/// Index of the first directional light that casts shadows, or -1.
int findSun(const Lighting& lighting) {
    for (size_t i = 0; i < lighting.directional.size(); ++i)
        if (lighting.directional[i].castsShadow) return int(i);
    return -1;
}

/// Some object colours the light that goes through it, in view or not.
bool hasGlass(const FrameWorlds& worlds) {
    bool found = false;
    worlds.forEachVariant([&](uint32_t flags) { found |= coloursLight(flags); });
    return found;
}

}  // namespace

ShadowStage::Views ShadowStage::chooseViews(FrameContext& frame) {
    const Lighting& lighting = frame.input.lighting;
    cascades_.count = 0;
    others_.clear();
    Views views{frame.settings().shadows ? findSun(lighting) : -1, &cascades_, &others_};
    const Aabb bounds = frame.worlds.bounds();
    if (views.sun < 0 || bounds.isEmpty()) return views;
    ShadowCascadeDesc desc;
    desc.lightDirection = lighting.directional[size_t(views.sun)].direction;
    desc.count = frame.settings().shadowCascades;
    desc.resolution = frame.settings().shadowResolution;
    desc.distance = frame.settings().shadowDistance;
    desc.rim = frame.settings().shadowFilter == ShadowFilter::soft ? RL_SHADOW_RIM_SOFT
                                                                   : RL_SHADOW_RIM;
    desc.sceneBounds = bounds;
    cascades_ = makeShadowCascades(frame.camera, desc);
    SecondSuns::Inputs others;
    others.camera = &frame.camera;
    others.directional = lighting.directional;
    others.sun = views.sun;
    others.cascades = desc;
    others.worlds = frame.worlds;
    others.geometry = &frame.stores.geometry;
    others.settings = &frame.settings();
    others_.plan(others, frame.jobs);
    return views;
}

void ShadowStage::scheduleLights(FrameContext& frame, const Inputs& inputs, Outputs& out) {
    const FrameSettings& settings = frame.settings();
    ViewHistory& history = frame.view.next;
    if (history.atlasImages.atlas != frame.view.images.generationOf(AtlasGenerations::kAtlas))
        history.shadowAtlas.forgetContents();
    ShadowLights::Inputs in;
    in.camera = &frame.camera;
    in.targetHeight = frame.height();
    if (settings.shadows && settings.lightShadows) {
        in.punctual = frame.input.lighting.punctual;
        in.area = frame.input.lighting.area;
    }
    out.punctualCast = std::ranges::any_of(in.punctual, &PunctualLight::castsShadow);
    out.areaCast = std::ranges::any_of(in.area, &AreaLight::castsShadow);
    in.settings = &settings;
    in.firstFace = inputs.views.others->count() *
                   uint32_t(sizeof(GpuSecondSun) / sizeof(GpuShadowFace));
    out.lights = lights_.select(in, history.shadowAtlas);
    out.punctual = lights_.records();
    out.area = lights_.areaRecords();
    ShadowSchedule::Inputs schedule;
    schedule.worlds = frame.worlds;
    schedule.world = frame.input.world;
    schedule.geometry = &frame.stores.geometry;
    schedule.faces = lights_.faces();
    schedule.caching = settings.shadowCaching;
    schedule.hasGlass = hasGlass(frame.worlds);
    schedule_.plan(schedule, frame.jobs);
    for (ShadowDraw& draw : schedule_.draws())
        draw.viewUniforms = frame.upload(makeViewUniforms(draw.face->view));
    for (GlassDraw& draw : schedule_.glassDraws())
        draw.viewUniforms = frame.upload(makeViewUniforms(draw.face->view));
    schedule_.forEachList([&](DrawList& list) { frame.drawn.push_back(&list); });
    out.drawn += schedule_.drawn();
    out.cached += schedule_.cached();
}

Result<void> ShadowStage::addSun(FrameContext& frame, const Inputs& inputs, Outputs& out) {
    const auto add = [&](const ShadowCascade& cascade, DrawList& casters, DrawList& glass) {
        const BufferRange view = frame.upload(makeViewUniforms(cascade));
        glassViews_[out.sunViews] = {&glass, view, 0};
        sunViews_[out.sunViews++] = {&cascade, &casters, view};
    };
    for (uint32_t i = 0; i < cascades_.count; ++i)
        add(cascades_.cascades[i], inputs.lists->casters[i], inputs.lists->glass[i]);
    for (uint32_t i = 0; i < others_.viewCount(); ++i)
        add(others_.cascade(i), others_.casters(i), others_.glass(i));
    ShadowPass::Inputs in;
    in.views = std::span(sunViews_).first(out.sunViews);
    in.resolution = cascades_.resolution;
    in.binder = frame.binder();
    in.world = frame.input.world;
    in.worlds = &frame.worlds;
    in.caching = frame.settings().shadowCaching;
    in.images = &frame.view.images;
    in.history = &frame.view.next.sunShadows;
    const auto opaque = sunPass_.add(frame.plan, in);
    if (!opaque) return tl::unexpected(opaque.error());
    for (uint32_t i = 0; i < out.sunViews; ++i)
        if (opaque->drawnViews >> i & 1) frame.drawn.push_back(sunViews_[i].casters);
    out.sunMap = opaque->map;
    out.drawn += opaque->drawn;
    out.cached += opaque->cached;
    return addSunGlass(frame, *opaque, cascades_.resolution, out);
}

Result<void> ShadowStage::addSunGlass(FrameContext& frame, const ShadowPass::Outputs& opaque,
                                      uint32_t resolution, Outputs& out) {
    for (uint32_t i = 0; i < out.sunViews; ++i) glassViews_[i].opaque = opaque.contents[i];
    ShadowGlassPass::SunInputs in;
    in.views = std::span(glassViews_).first(out.sunViews);
    in.map = opaque.map;
    in.resolution = resolution;
    in.binder = frame.binder();
    in.caching = frame.settings().shadowCaching;
    in.hasGlass = hasGlass(frame.worlds);
    in.worlds = &frame.worlds;
    in.images = &frame.view.images;
    in.history = &frame.view.next.sunGlass;
    const auto glass = glassPass_.addSun(frame.plan, in);
    if (!glass) return tl::unexpected(glass.error());
    for (uint32_t i = 0; i < out.sunViews; ++i)
        if (glass->drawnViews >> i & 1) frame.drawn.push_back(glassViews_[i].casters);
    out.sunGlass = glass->glass;
    const auto more = uint32_t(std::popcount(glass->drawnViews & ~opaque.drawnViews));
    out.drawn += more;
    out.cached -= more;
    return {};
}

Result<void> ShadowStage::addLights(FrameContext& frame, Outputs& out) {
    ShadowAtlasPass::Inputs in;
    in.draws = schedule_.draws();
    in.binder = frame.binder();
    in.size = lights_.atlasSize();
    in.worlds = &frame.worlds;
    in.images = &frame.view.images;
    in.history = &frame.view.next.atlasImages;
    const auto atlas = atlasPass_.add(frame.plan, in);
    if (!atlas) return tl::unexpected(atlas.error());
    out.atlas = atlas->atlas;
    if (!schedule_.hasGlass()) return {};
    ShadowGlassPass::AtlasInputs glass;
    glass.draws = schedule_.glassDraws();
    glass.atlas = atlas->atlas;
    glass.size = lights_.atlasSize();
    glass.binder = frame.binder();
    glass.worlds = &frame.worlds;
    glass.images = &frame.view.images;
    glass.history = &frame.view.next.atlasImages;
    const auto made = glassPass_.addAtlas(frame.plan, glass);
    if (!made) return tl::unexpected(made.error());
    out.atlasGlass = *made;
    return {};
}

void ShadowStage::uploadRecords(FrameContext& frame, const SecondSuns& others, Outputs& out) {
    const auto faces = lights_.gpuFaces();
    if (others.count() == 0) {
        const GpuShadowFace none{};
        if (out.punctualCast || out.areaCast)
            out.records = frame.uploads.append(faces.empty() ? std::span(&none, 1) : faces);
        return;
    }
    const auto suns = others.gpu();
    records_.resize(suns.size_bytes() / sizeof(GpuShadowFace));
    std::memcpy(static_cast<void*>(records_.data()), suns.data(), suns.size_bytes());
    records_.insert(records_.end(), faces.begin(), faces.end());
    out.records = frame.uploads.append(std::span<const GpuShadowFace>(records_));
}

Result<ShadowStage::Outputs> ShadowStage::add(FrameContext& frame, const Inputs& inputs) {
    Outputs out;
    scheduleLights(frame, inputs, out);
    if (cascades_.count > 0)
        if (auto ok = addSun(frame, inputs, out); !ok) return tl::unexpected(ok.error());
    if (out.punctualCast || out.areaCast)
        if (auto ok = addLights(frame, out); !ok) return tl::unexpected(ok.error());
    uploadRecords(frame, *inputs.views.others, out);
    return out;
}

}  // namespace rushlight

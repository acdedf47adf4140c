// The shadow views of a frame: the sun's cascades, and the faces of point, spot and area lights.
#include "renderer/pipeline/frame_renderer.h"
#include "renderer/pipeline/lighting_uniforms.h"

#include <bit>
#include <cstring>

namespace rushlight {

void FrameRenderer::planShadows(const FrameInput& input, const CameraMatrices& camera) {
    sun_ = input.settings.shadows ? findSun(input.lighting) : -1;
    cascades_.count = 0;
    secondSuns_.clear();
    if (sun_ < 0) return;
    const Aabb bounds = frameWorlds_.bounds();
    if (bounds.isEmpty()) return;
    ShadowCascadeDesc desc;
    desc.lightDirection = input.lighting.directional[size_t(sun_)].direction;
    desc.count = input.settings.shadowCascades;
    desc.resolution = input.settings.shadowResolution;
    desc.distance = input.settings.shadowDistance;
    desc.rim = input.settings.shadowFilter == ShadowFilter::soft ? RL_SHADOW_RIM_SOFT
                                                                 : RL_SHADOW_RIM;
    desc.sceneBounds = bounds;
    cascades_ = makeShadowCascades(camera, desc);
    SecondSuns::Inputs second;
    second.camera = &camera;
    second.directional = input.lighting.directional;
    second.sun = sun_;
    second.cascades = desc;
    second.worlds = frameWorlds_;
    second.geometry = &geometry;
    second.settings = &input.settings;
    secondSuns_.plan(second, jobs_);
}

void FrameRenderer::planLightShadows(const FrameInput& input, const FrameOutput& output,
                                     const CameraMatrices& camera) {
    const FrameSettings& settings = input.settings;
    shadowLightCounts_ = {};
    ShadowLights::Inputs in;
    in.camera = &camera;
    in.targetHeight = output.target.height;
    if (settings.shadows && settings.lightShadows) {
        in.punctual = input.lighting.punctual;
        in.area = input.lighting.area;
    }
    in.settings = &settings;
    in.firstFace = secondSuns_.count() * uint32_t(sizeof(GpuSecondSun) / sizeof(GpuShadowFace));
    shadowLightCounts_ = shadowLights_.select(in);
    ShadowSchedule::Inputs schedule;
    schedule.worlds = frameWorlds_;
    schedule.world = input.world;
    schedule.geometry = &geometry;
    schedule.faces = shadowLights_.faces();
    schedule.caching = settings.shadowCaching;
    shadowSchedule_.plan(schedule, jobs_);
    for (ShadowDraw& draw : shadowSchedule_.draws())
        draw.viewUniforms = uniforms(makeViewUniforms(draw.face->view));
    for (GlassDraw& draw : shadowSchedule_.glassDraws())
        draw.viewUniforms = uniforms(makeViewUniforms(draw.face->view));
}

Result<void> FrameRenderer::addSunShadowPass(const FrameInput& input, LightingBindings& lighting) {
    const auto add = [&](const ShadowCascade& cascade, DrawList& casters, DrawList& glass) {
        const BufferRange view = uniforms(makeViewUniforms(cascade));
        sunGlassViews_[sunViewCount_] = {&glass, view, 0};
        sunViews_[sunViewCount_++] = {&cascade, &casters, view};
    };
    for (uint32_t i = 0; i < cascades_.count; ++i)
        add(cascades_.cascades[i], lists_.casters[i], lists_.glass[i]);
    for (uint32_t i = 0; i < secondSuns_.viewCount(); ++i)
        add(secondSuns_.cascade(i), secondSuns_.casters(i), secondSuns_.glass(i));
    ShadowPass::Inputs in;
    in.views = std::span(sunViews_).first(sunViewCount_);
    in.resolution = cascades_.resolution;
    in.binder = {&geometry, &materials};
    in.world = input.world;
    in.caching = input.settings.shadowCaching;
    auto shadows = shadowPass_.add(plan_, in);
    if (!shadows) return tl::unexpected(shadows.error());
    shadows_ = *shadows;
    lighting.shadowMap = shadows_.map;
    return addSunGlassPass(input, lighting);
}

Result<void> FrameRenderer::addSunGlassPass(const FrameInput& input, LightingBindings& lighting) {
    for (uint32_t i = 0; i < sunViewCount_; ++i) sunGlassViews_[i].opaque = shadows_.contents[i];
    ShadowGlassPass::SunInputs in;
    in.views = std::span(sunGlassViews_).first(sunViewCount_);
    in.map = shadows_.map;
    in.resolution = cascades_.resolution;
    in.binder = {&geometry, &materials};
    in.caching = input.settings.shadowCaching;
    const auto glass = shadowGlassPass_.addSun(plan_, in);
    if (!glass) return tl::unexpected(glass.error());
    sunGlass_ = *glass;
    lighting.sunGlass = sunGlass_.glass;
    lighting.features.sunGlass = bool(sunGlass_.glass);
    const auto more = uint32_t(std::popcount(sunGlass_.drawnViews & ~shadows_.drawnViews));
    shadows_.drawn += more;
    shadows_.cached -= more;
    return {};
}

Result<void> FrameRenderer::addShadowPasses(const FrameInput& input, LightingBindings& lighting) {
    shadows_ = {};
    sunGlass_ = {};
    sunViewCount_ = 0;
    if (cascades_.count > 0)
        if (auto ok = addSunShadowPass(input, lighting); !ok) return ok;
    if (!shadowLights_.faces().empty())
        if (auto ok = addLightShadowPass(lighting); !ok) return ok;
    bindShadowRecords(lighting);
    return {};
}

// Of second suns, then of the other lights' faces.
void FrameRenderer::bindShadowRecords(LightingBindings& lighting) {
    const auto faces = shadowLights_.gpuFaces();
    if (secondSuns_.count() == 0) {
        if (!faces.empty()) lighting.shadowFaces = commands_.append(faces);
        return;
    }
    const auto suns = secondSuns_.gpu();
    shadowRecords_.resize(suns.size_bytes() / sizeof(GpuShadowFace));
    std::memcpy(static_cast<void*>(shadowRecords_.data()), suns.data(), suns.size_bytes());
    shadowRecords_.insert(shadowRecords_.end(), faces.begin(), faces.end());
    lighting.shadowFaces = commands_.append(std::span<const GpuShadowFace>(shadowRecords_));
}

Result<void> FrameRenderer::addLightShadowPass(LightingBindings& lighting) {
    ShadowAtlasPass::Inputs in;
    in.draws = shadowSchedule_.draws();
    in.binder = {&geometry, &materials};
    in.size = shadowLights_.atlasSize();
    auto atlas = shadowAtlasPass_.add(plan_, in);
    if (!atlas) return tl::unexpected(atlas.error());
    lighting.shadowAtlas = atlas->atlas;
    return shadowSchedule_.hasGlass() ? addLightGlassPass(lighting) : Result<void>();
}

Result<void> FrameRenderer::addLightGlassPass(LightingBindings& lighting) {
    ShadowGlassPass::AtlasInputs in;
    in.draws = shadowSchedule_.glassDraws();
    in.atlas = lighting.shadowAtlas;
    in.size = shadowLights_.atlasSize();
    in.binder = {&geometry, &materials};
    const auto glass = shadowGlassPass_.addAtlas(plan_, in);
    if (!glass) return tl::unexpected(glass.error());
    lighting.atlasGlass = *glass;
    lighting.features.atlasGlass = lighting.features.punctualShadow || lighting.features.areaShadow;
    return {};
}

}  // namespace rushlight

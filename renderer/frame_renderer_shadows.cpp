// The shadow views of a frame: the sun's cascades, and the faces of point, spot and area lights.
#include "renderer/frame/lighting_setup.h"
#include "renderer/frame_renderer.h"

namespace rushlight {

void FrameRenderer::planShadows(const FrameInput& input, const CameraMatrices& camera) {
    sun_ = input.settings.shadows ? findSun(input.lighting) : -1;
    cascades_.count = 0;
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
}

Result<void> FrameRenderer::addShadowPasses(const FrameInput& input, LightingBindings& lighting) {
    shadows_ = {};
    if (cascades_.count > 0) {
        ShadowPass::Inputs in;
        in.cascades = &cascades_;
        for (uint32_t i = 0; i < cascades_.count; ++i) {
            in.casters[i] = &lists_.casters[i];
            in.viewUniforms[i] = uniforms(makeViewUniforms(cascades_.cascades[i]));
        }
        in.binder = {&geometry, &materials};
        in.world = input.world;
        in.caching = input.settings.shadowCaching;
        auto shadows = shadowPass_.add(plan_, in);
        if (!shadows) return tl::unexpected(shadows.error());
        shadows_ = *shadows;
        lighting.shadowMap = shadows_.map;
    }
    return shadowLights_.faces().empty() ? Result<void>() : addLightShadowPass(lighting);
}

Result<void> FrameRenderer::addLightShadowPass(LightingBindings& lighting) {
    ShadowAtlasPass::Inputs in;
    in.draws = shadowSchedule_.draws();
    in.binder = {&geometry, &materials};
    in.size = shadowLights_.atlasSize();
    auto atlas = shadowAtlasPass_.add(plan_, in);
    if (!atlas) return tl::unexpected(atlas.error());
    lighting.shadowAtlas = atlas->atlas;
    lighting.shadowFaces = commands_.append(shadowLights_.gpuFaces());
    return {};
}

}  // namespace rushlight

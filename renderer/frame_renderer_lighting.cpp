// From the lights of a frame to what the lighting shaders read.
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
    desc.sceneBounds = bounds;
    cascades_ = makeShadowCascades(camera, desc);
}

Result<LightingBindings> FrameRenderer::bindLighting(const FrameInput& input,
                                                     const CameraMatrices& camera,
                                                     const FrameOutput& output) {
    const Lighting& lighting = input.lighting;
    clusters_.build(camera, output.target.width, output.target.height,
                    {lighting.punctual, {}, lighting.area}, jobs_);
    const GpuEnvironment* environment = environments.find(lighting.environment);

    LightingBindings b;
    b.features.directionalLights = uint32_t(lighting.directional.size());
    b.features.shadowCascades = cascades_.count;
    const auto& ofClass = clusters_.visibleOfClass;
    b.features.plainLights = ofClass[size_t(LightClass::plain)] > 0;
    b.features.modulatedLights = ofClass[size_t(LightClass::modulated)] > 0;
    b.features.areaLights = ofClass[size_t(LightClass::area)] > 0;
    b.features.environment = environment != nullptr;
    b.features.hemisphere =
        lighting.ambientSky != vec3(0) || lighting.ambientGround != vec3(0);
    b.features.orthographic = !camera.perspective;
    b.uniforms = uniforms(
        makeLightingUniforms(camera, lighting, sun_, clusters_, cascades_, environment));
    if (b.features.clusteredLights()) {
        b.lights = commands_.append(std::span<const GpuLight>(clusters_.lights));
        b.clusters = commands_.append(std::span<const uint32_t>(clusters_.clusters));
        b.lightIndices = commands_.append(std::span<const uint16_t>(clusters_.indices));
    }
    b.shadowSampler = shadowSampler_;
    b.cubeSampler = cubeSampler_;
    b.linearSampler = linearSampler_;
    if (environment) {
        b.environment = environment->specular;
        b.irradiance = environment->irradiance;
        b.sky = environment->background;
    }
    auto table = environments.brdfTable();
    if (!table) return tl::unexpected(table.error());
    b.brdfTable = *table;
    if (b.features.areaLights) {
        auto ltc = environments.ltcTable();
        if (!ltc) return tl::unexpected(ltc.error());
        b.ltcTable = *ltc;
    }
    return b;
}

}  // namespace rushlight

// From the lights of a frame to what the lighting shaders read.
#include "renderer/pipeline/frame_renderer.h"
#include "renderer/pipeline/lighting_uniforms.h"

namespace rushlight {

Result<LightingBindings> FrameRenderer::bindLighting(const FrameInput& input,
                                                     const CameraMatrices& camera,
                                                     const FrameOutput& output) {
    const Lighting& lighting = input.lighting;
    clusters_.build(camera, output.target.width, output.target.height,
                    {lighting.punctual, shadowLights_.records(), lighting.area,
                     shadowLights_.areaRecords(), &lightPatterns},
                    jobs_);
    const GpuEnvironment* environment = environments.find(lighting.environment);

    const GpuIrradianceVolume* volume = irradianceVolumes.find(lighting.irradianceVolume);

    LightingBindings b;
    b.features.directionalLights = uint32_t(lighting.directional.size());
    b.features.shadowCascades = cascades_.count;
    b.features.secondSuns = secondSuns_.count();
    b.features.secondCascades = secondSuns_.cascadesOfEach();
    const auto& ofClass = clusters_.visibleOfClass;
    b.features.plainLights = ofClass[size_t(LightClass::plain)] > 0;
    b.features.modulatedLights = ofClass[size_t(LightClass::modulated)] > 0;
    b.features.areaLights = ofClass[size_t(LightClass::area)] > 0;
    b.features.environment = environment != nullptr;
    b.features.hemisphere = lighting.ambientSky != vec3(0) || lighting.ambientGround != vec3(0);
    b.features.ambientReflections = input.settings.ambientReflections;
    b.features.orthographic = !camera.perspective;
    if (volume) {
        b.features.irradianceVolume = true;
        b.probeDistances = volume->distances;
        b.probeRecords = volume->recordRange();
    }
    interop::LightingUniforms u = makeLightingUniforms(camera, lighting, sun_, clusters_, cascades_,
                                                       environment, volume);
    fogGrid_ = makeFogGrid(lighting.fog, camera, output.target.width, output.target.height);
    if (lighting.fog.density > 0 || input.settings.show == ShownImage::fog)
        fillFog(lighting.fog, fogGrid_, camera, u);
    u.depthDecode.z = input.settings.contactShadowLength;
    b.uniforms = uniforms(u);
    if (b.features.clusteredLights()) {
        b.lights = commands_.append(std::span<const GpuLight>(clusters_.lights));
        b.clusters = commands_.append(std::span<const uint32_t>(clusters_.clusters));
        b.lightIndices = commands_.append(std::span<const uint16_t>(clusters_.indices));
    }
    b.features.punctualShadow = !shadowLights_.records().empty() && b.features.modulatedLights;
    if (clusters_.visiblePatterns > 0) {
        b.features.lightPatterns = true;
        b.lightPatterns = lightPatterns.texture();
        b.patternSampler = lightPatterns.sampler();
    }
    b.features.areaShadow = !shadowLights_.areaRecords().empty() && b.features.areaLights;
    if (auto ok = reflections.prepare(lighting.reflectionProbes, camera); !ok)
        return tl::unexpected(ok.error());
    if (!reflections.empty()) {
        b.features.reflectionProbes = true;
        b.reflectionCubes = reflections.cubes();
        b.reflectionIrradiance = reflections.irradiance();
        b.reflectionRecords = commands_.append(reflections.records());
    }
    b.features.shadowFilter = input.settings.shadowFilter;
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

DecalBindings FrameRenderer::bindDecals(const FrameInput& input, const FrameOutput& output,
                                        const CameraMatrices& camera, interop::ViewUniforms& view) {
    DecalBindings b;
    if (input.decals.empty()) return b;
    decalClusters_.build(camera, output.target.width, output.target.height, input.decals, decals);
    if (decalClusters_.decals.empty()) return b;
    view.decalMapping = decalClusters_.mapping();
    const float half = camera.perspective ? camera.tanHalfY : camera.halfHeight;
    view.decalScale.x = 2 * half / float(output.target.height);
    b.records = commands_.append(std::span<const GpuDecal>(decalClusters_.decals));
    b.lists = commands_.append(std::span<const uint32_t>(decalClusters_.lists));
    b.color = decals.color();
    b.detail = decals.detail();
    b.sampler = decalSampler_;
    return b;
}

Result<ImageId> FrameRenderer::planFog(const FrameInput& input, const LightingBindings& lighting,
                                       ImageId radiance, ImageId depth) {
    const bool alone = input.settings.show == ShownImage::fog;
    if (!alone && !(input.lighting.fog.density > 0)) return ImageId{};
    LightingBindings around = lighting;
    around.features.reflectionProbes = false;  // air mirrors nothing
    const auto fog = fogPass_.add(plan_, {around, fogGrid_});
    if (!fog) return tl::unexpected(fog.error());
    if (alone)
        radiance = plan_.createImage(
            {"fog-alone", Format::rgba16f, fogGrid_.width, fogGrid_.height});
    const auto applied = fogPass_.apply(plan_, {fog->fog, radiance, depth, lighting.uniforms, alone,
                                                lighting.features.orthographic});
    if (!applied) return tl::unexpected(applied.error());
    return alone ? radiance : fog->fog;
}

}  // namespace rushlight

#include "renderer/pipeline/stages/lighting_stage.h"

#include "renderer/passes/screen/screen_uniforms.h"
#include "renderer/pipeline/stages/lighting_uniforms.h"

namespace rushlight {
namespace {

// A buffer texture needs a range with something in it, even if nothing of it is looked up.
template <class T>
BufferRange appendSome(CommandBuffer& uploads, std::span<const T> values) {
    const T none{};
    return uploads.append(values.empty() ? std::span(&none, 1) : values);
}

}  // namespace

LightingStage::LightingStage(Device& device)
    : gtaoPass_(device),
      irradiancePass_(device),
      lightingPass_(device),
      shadowSampler_(nearestClampSampler(device)),
      cubeSampler_(trilinearClampSampler(device)),
      linearSampler_(linearClampSampler(device)) {}

// Features follow from what the frame is given and not from what is in view, so that turning the
// camera compiles nothing.
LightingFeatures LightingStage::featuresOf(FrameContext& frame, const Inputs& inputs) const {
    const Lighting& lighting = frame.input.lighting;
    const ShadowStage::Outputs& shadows = *inputs.shadows;
    const SecondSuns& others = *inputs.views->others;
    LightingFeatures f;
    f.directionalLights = uint32_t(lighting.directional.size());
    f.shadowCascades = inputs.views->cascades->count;
    f.secondSuns = others.count();
    f.secondCascades = others.cascadesOfEach();
    f.plainLights = clusters_.hasClass[size_t(LightClass::plain)];
    f.modulatedLights = clusters_.hasClass[size_t(LightClass::modulated)];
    f.areaLights = clusters_.hasClass[size_t(LightClass::area)];
    f.environment = frame.stores.environments.find(lighting.environment) != nullptr;
    f.hemisphere = lighting.ambientSky != vec3(0) || lighting.ambientGround != vec3(0);
    f.ambientReflections = frame.settings().ambientReflections;
    f.orthographic = !frame.camera.perspective;
    f.irradianceVolume = frame.stores.irradianceVolumes.find(lighting.irradianceVolume) != nullptr;
    f.punctualShadow = shadows.punctualCast;
    f.areaShadow = shadows.areaCast;
    f.lightPatterns = clusters_.hasPatterns;
    f.reflectionProbes = !lighting.reflectionProbes.empty();
    f.shadowFilter = frame.settings().shadowFilter;
    f.sunGlass = bool(shadows.sunGlass);
    f.atlasGlass = shadows.atlasGlass && (f.punctualShadow || f.areaShadow);
    return f;
}

void LightingStage::bindLights(FrameContext& frame, LightingBindings& b) const {
    if (b.features.clusteredLights()) {
        CommandBuffer& uploads = frame.uploads;
        b.lights = appendSome<GpuLight>(uploads, clusters_.lights);
        b.clusters = appendSome<uint32_t>(uploads, clusters_.clusters);
        b.lightIndices = appendSome<uint16_t>(uploads, clusters_.indices);
    }
    if (b.features.lightPatterns) {
        b.lightPatterns = frame.stores.lightPatterns.texture();
        b.patternSampler = frame.stores.lightPatterns.sampler();
    }
}

Result<void> LightingStage::bindSurroundings(FrameContext& frame, LightingBindings& b) const {
    Stores& stores = frame.stores;
    const Lighting& lighting = frame.input.lighting;
    if (const auto* volume = stores.irradianceVolumes.find(lighting.irradianceVolume)) {
        b.probeDistances = volume->distances;
        b.probeRecords = volume->recordRange();
    }
    if (b.features.reflectionProbes) {
        b.reflectionCubes = stores.reflections.cubes();
        b.reflectionIrradiance = stores.reflections.irradiance();
        b.reflectionRecords = frame.uploads.append(stores.reflections.records());
    }
    if (const GpuEnvironment* environment = stores.environments.find(lighting.environment)) {
        b.environment = environment->specular;
        b.irradiance = environment->irradiance;
        b.sky = environment->background;
    }
    auto table = stores.environments.brdfTable();
    if (!table) return tl::unexpected(table.error());
    b.brdfTable = *table;
    if (!b.features.areaLights) return {};
    auto ltc = stores.environments.ltcTable();
    if (!ltc) return tl::unexpected(ltc.error());
    b.ltcTable = *ltc;
    return {};
}

Result<LightingBindings> LightingStage::bind(FrameContext& frame, const Inputs& inputs,
                                             FogGrid& fog) {
    Stores& stores = frame.stores;
    const Lighting& lighting = frame.input.lighting;
    const ShadowStage::Outputs& shadows = *inputs.shadows;
    clusters_.build(frame.camera, frame.width(), frame.height(),
                    {lighting.punctual, shadows.punctual, lighting.area, shadows.area,
                     &stores.lightPatterns, shadows.punctualCast},
                    frame.jobs);
    if (auto ok = stores.reflections.prepare(lighting.reflectionProbes, frame.camera); !ok)
        return tl::unexpected(ok.error());

    interop::LightingUniforms u = makeLightingUniforms(
        frame.camera, lighting, inputs.views->sun, clusters_, *inputs.views->cascades,
        stores.environments.find(lighting.environment),
        stores.irradianceVolumes.find(lighting.irradianceVolume));
    fog = makeFogGrid(lighting.fog, frame.camera, frame.width(), frame.height());
    if (lighting.fog.density > 0 || frame.plan.wants("fog"))
        fillFog(lighting.fog, fog, frame.camera, u);
    u.depthDecode.z = frame.settings().contactShadowLength;

    LightingBindings b;
    b.features = featuresOf(frame, inputs);
    b.uniforms = frame.upload(u);
    b.shadowMap = shadows.sunMap;
    b.shadowAtlas = shadows.atlas;
    b.sunGlass = shadows.sunGlass;
    b.atlasGlass = shadows.atlasGlass;
    b.shadowFaces = shadows.records;
    b.shadowSampler = shadowSampler_;
    b.cubeSampler = cubeSampler_;
    b.linearSampler = linearSampler_;
    bindLights(frame, b);
    if (auto ok = bindSurroundings(frame, b); !ok) return tl::unexpected(ok.error());
    return b;
}

// Included first where a frame has ambient light; where it has none, when it is asked for by name.
Result<ImageId> LightingStage::addAmbientOcclusion(FrameContext& frame,
                                                   const GBufferPass::Outputs& gbuffer,
                                                   const LightingFeatures& features) {
    const FrameSettings& settings = frame.settings();
    const bool needed = settings.ambientOcclusion != AmbientOcclusion::off &&
                        (features.environment || features.hemisphere || features.irradianceVolume ||
                         features.reflectionProbes);
    if (!needed && !frame.plan.wants("ambient-occlusion")) return ImageId{};
    GtaoPass::Inputs in;
    in.gbuffer = gbuffer;
    in.quality = needed ? settings.ambientOcclusion : AmbientOcclusion::medium;
    in.radius = settings.ambientOcclusionRadius;
    in.orthographic = !frame.camera.perspective;
    in.data = &frame.uploads;
    in.width = frame.width();
    in.height = frame.height();
    in.screen = makeScreenUniforms(frame.camera, in.width, in.height);
    const auto made = gtaoPass_.add(frame.plan, in);
    if (!made) return tl::unexpected(made.error());
    frame.plan.publish("ambient-occlusion", made->occlusion);
    return made->occlusion;
}

// The lit radiance taken apart, for those who ask for it.
Result<void> LightingStage::addParts(FrameContext& frame, LightingPass::Inputs inputs) {
    for (const LightingPart part :
         {LightingPart::untextured, LightingPart::direct, LightingPart::ambient,
          LightingPart::ambientShare, LightingPart::emission}) {
        if (!frame.plan.wants(toText(part))) continue;
        inputs.part = part;
        const auto lit = lightingPass_.add(frame.plan, inputs);
        if (!lit) return tl::unexpected(lit.error());
        frame.plan.publish(toText(part), lit->radiance);
    }
    return {};
}

Result<LightingStage::Outputs> LightingStage::add(FrameContext& frame, const Inputs& inputs) {
    const GBufferPass::Outputs& gbuffer = inputs.surface->gbuffer;
    Outputs out;
    auto bindings = bind(frame, inputs, out.fog);
    if (!bindings) return tl::unexpected(bindings.error());
    out.lighting = *bindings;
    out.clusters = &clusters_;
    const LightingFeatures& features = out.lighting.features;
    const auto ambient = addAmbientOcclusion(frame, gbuffer, features);
    if (!ambient) return tl::unexpected(ambient.error());
    out.ambientOcclusion = *ambient;
    if (features.irradianceVolume) {
        const auto local = irradiancePass_.add(
            frame.plan, {gbuffer, out.lighting, frame.width(), frame.height()});
        if (!local) return tl::unexpected(local.error());
        out.localTint = local->tint;
        out.localFlow = local->flow;
    }
    LightingPass::Inputs in;
    in.gbuffer = gbuffer;
    in.lighting = out.lighting;
    in.ambientOcclusion = out.ambientOcclusion;
    in.localTint = out.localTint;
    in.localFlow = out.localFlow;
    in.showSky = features.environment && frame.input.lighting.background == Background::environment;
    in.width = frame.width();
    in.height = frame.height();
    const ContactShadows contact = frame.settings().contactShadows;
    in.sunContact = contact != ContactShadows::off && inputs.views->sun >= 0;
    in.lightContact = contact == ContactShadows::lights && features.punctualShadow;
    if (auto ok = addParts(frame, in); !ok) return tl::unexpected(ok.error());
    const auto lit = lightingPass_.add(frame.plan, in);
    if (!lit) return tl::unexpected(lit.error());
    out.radiance = lit->radiance;
    frame.plan.publish("lighting", out.radiance);
    return out;
}

}  // namespace rushlight

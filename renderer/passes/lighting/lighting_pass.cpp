#include "renderer/passes/lighting/lighting_pass.h"

#include "renderer/passes/fullscreen.h"
#include "shaders/interop/bindings.h"

namespace rushlight {
namespace {

constexpr std::string_view kDirectionalDefines[] = {"DIRECTIONAL_LIGHTS 0", "DIRECTIONAL_LIGHTS 1",
                                                    "DIRECTIONAL_LIGHTS 2", "DIRECTIONAL_LIGHTS 3",
                                                    "DIRECTIONAL_LIGHTS 4"};
constexpr std::string_view kCascadeDefines[] = {"", "SHADOW_CASCADES 1", "SHADOW_CASCADES 2",
                                                "SHADOW_CASCADES 3", "SHADOW_CASCADES 4"};

constexpr std::string_view kSunDefines[] = {"", "SHADOWED_SUNS 2", "SHADOWED_SUNS 3",
                                            "SHADOWED_SUNS 4"};

// Indexed by LightingPart.
constexpr std::string_view kPartDefines[] = {
    "", "PART_UNTEXTURED", "PART_DIRECT", "PART_AMBIENT", "PART_AMBIENT_SHARE", "PART_EMISSION"};

bool hasBackground(LightingPart part) {
    return part == LightingPart::all || part == LightingPart::emission;
}

struct Payload {
    PipelineHandle lighting, background;
};

void record(const Payload& p, CommandBuffer& commands) {
    for (PipelineHandle pipeline : {p.lighting, p.background}) {
        if (!pipeline) continue;
        commands.push(SetPipeline{pipeline});
        commands.push(Draw{3, 1, 0});
    }
}

}  // namespace

const char* toText(LightingPart part) {
    // Indexed by LightingPart.
    constexpr const char* kNames[] = {"lighting", "untextured",    "direct",
                                      "ambient",  "ambient-share", "emission"};
    return kNames[size_t(part)];
}

void LightingFeatures::appendDefines(std::vector<std::string_view>& defines) const {
    defines.push_back(kDirectionalDefines[directionalLights]);
    if (shadowCascades > 0) {
        defines.push_back("SUN_SHADOW");
        defines.push_back(kCascadeDefines[shadowCascades]);
    }
    if (secondSuns > 0) {
        defines.push_back(kSunDefines[secondSuns]);
        defines.push_back(secondCascades > 1 ? "SECOND_CASCADES 2" : "SECOND_CASCADES 1");
    }
    if (clusteredLights()) defines.push_back("CLUSTERED_LIGHTS");
    if (plainLights) defines.push_back("PLAIN_LIGHTS");
    if (modulatedLights) defines.push_back("MODULATED_LIGHTS");
    if (punctualShadow) defines.push_back("PUNCTUAL_SHADOW");
    if (lightPatterns) defines.push_back("LIGHT_PATTERNS");
    if (shadowCascades > 0 || punctualShadow || areaShadow) {
        if (shadowFilter == ShadowFilter::hard) defines.push_back("SHADOW_HARD");
        if (shadowFilter == ShadowFilter::soft) defines.push_back("SHADOW_SOFT");
    }
    if (areaLights) defines.push_back("AREA_LIGHTS");
    if (areaShadow) defines.push_back("AREA_SHADOW");
    if (sunGlass) defines.push_back("SUN_GLASS");
    if (atlasGlass) defines.push_back("ATLAS_GLASS");
    if (environment)
        defines.push_back("ENVIRONMENT");
    else if (hemisphere)
        defines.push_back("HEMISPHERE");
    if (!ambientReflections) defines.push_back("NO_AMBIENT_REFLECTIONS");
    if (orthographic) defines.push_back("ORTHOGRAPHIC");
    if (irradianceVolume) defines.push_back("IRRADIANCE_VOLUME");
    if (reflectionProbes) defines.push_back("REFLECTION_PROBES");
}

void LightingBindings::bind(PassBuilder& pass) const {
    pass.uniforms(RL_UNIFORMS_LIGHTING, uniforms);
    if (features.shadowCascades > 0) pass.sample(RL_TEXTURE_SHADOW, shadowMap, shadowSampler);
    if (features.clusteredLights()) {
        pass.texels(RL_TEXTURE_LIGHTS, Format::rgba32f, lights);
        pass.texels(RL_TEXTURE_CLUSTERS, Format::r32ui, clusters);
        pass.texels(RL_TEXTURE_LIGHT_INDICES, Format::r16ui, lightIndices);
    }
    const bool atlas = features.punctualShadow || features.areaShadow;
    if (atlas) pass.sample(RL_TEXTURE_SHADOW_ATLAS, shadowAtlas, shadowSampler);
    if (atlas || features.secondSuns > 0)
        pass.texels(RL_TEXTURE_SHADOW_FACES, Format::rgba32f, shadowFaces);
    if (features.sunGlass) pass.sample(RL_TEXTURE_SUN_GLASS, sunGlass, linearSampler);
    if (features.atlasGlass) pass.sample(RL_TEXTURE_ATLAS_GLASS, atlasGlass, linearSampler);
    if (features.lightPatterns)
        pass.texture(RL_TEXTURE_LIGHT_PATTERNS, lightPatterns, patternSampler);
    if (features.environment) {
        pass.texture(RL_TEXTURE_ENVIRONMENT, environment, cubeSampler);
        if (!features.irradianceVolume)
            pass.texture(RL_TEXTURE_IRRADIANCE, irradiance, cubeSampler);
    }
    if (features.reflectionProbes) {
        pass.texture(RL_TEXTURE_REFLECTION_CUBES, reflectionCubes, cubeSampler);
        if (!features.irradianceVolume)
            pass.texture(RL_TEXTURE_REFLECTION_IRRADIANCE, reflectionIrradiance, cubeSampler);
        pass.texels(RL_TEXTURE_REFLECTION_RECORDS, Format::rgba32f, reflectionRecords);
    }
    if (features.areaLights) pass.texture(RL_TEXTURE_LTC, ltcTable, linearSampler);
    pass.texture(RL_TEXTURE_BRDF_TABLE, brdfTable, linearSampler);
}

void LightingBindings::bindProbes(PassBuilder& pass) const {
    pass.texture(RL_TEXTURE_PROBE_DISTANCES, probeDistances, linearSampler);
    pass.texels(RL_TEXTURE_PROBE_RECORDS, Format::rgba32ui, probeRecords);
}

void LitScreenBindings::bind(PassBuilder& pass) const {
    lighting.bind(pass);
    pass.sample(RL_TEXTURE_GBUFFER0, gbuffer.target0, nearest);
    pass.sample(RL_TEXTURE_GBUFFER1, gbuffer.target1, nearest);
    pass.sample(RL_TEXTURE_GBUFFER2, gbuffer.target2, nearest);
    pass.sample(RL_TEXTURE_DEPTH, gbuffer.depth, nearest);
    pass.sample(RL_TEXTURE_AMBIENT_OCCLUSION, ambientOcclusion, nearest);
    if (!lighting.features.irradianceVolume) return;
    pass.sample(RL_TEXTURE_LOCAL_TINT, localTint, nearest);
    pass.sample(RL_TEXTURE_LOCAL_FLOW, localFlow, lighting.linearSampler);
}

LightingPass::LightingPass(Device& device)
    : device_(device), nearest_(nearestClampSampler(device)) {}

// Both are full-screen triangles at the far plane. Lighting is drawn where something is nearer, the
// background where nothing is: rejected by depth, pixels cost nothing, while a branch in the shader
// would save nothing on llvmpipe.
Result<LightingPass::Entry> LightingPass::find(const Inputs& inputs) {
    Entry entry{inputs.lighting.features,
                bool(inputs.ambientOcclusion),
                inputs.showSky,
                inputs.sunContact,
                inputs.lightContact,
                inputs.part,
                {},
                {}};
    for (const Entry& known : entries_)
        if (known.features == entry.features && known.showSky == entry.showSky &&
            known.ambientOcclusion == entry.ambientOcclusion &&
            known.sunContact == entry.sunContact && known.lightContact == entry.lightContact &&
            known.part == entry.part)
            return known;
    std::vector<std::string_view> defines;
    entry.features.appendDefines(defines);
    if (entry.ambientOcclusion) defines.push_back("AMBIENT_OCCLUSION");
    if (entry.sunContact) defines.push_back("SUN_CONTACT");
    if (entry.lightContact) defines.push_back("LIGHT_CONTACT");
    if (entry.part != LightingPart::all) {
        defines.push_back("LIGHTING_PART");
        defines.push_back(kPartDefines[size_t(entry.part)]);
    }
    PipelineDesc desc;
    desc.label = "lighting";
    desc.vertexShader = "passes/lighting/lighting.vert";
    desc.fragmentShader = "passes/lighting/lighting.frag";
    desc.defines = defines;
    desc.depthTest = CompareOp::less;
    auto lighting = device_.createPipeline(desc);
    if (!lighting) return tl::unexpected(lighting.error());

    std::vector<std::string_view> backgroundDefines{"BACKGROUND", "DIRECTIONAL_LIGHTS 0"};
    if (entry.showSky) backgroundDefines.push_back("ENVIRONMENT");
    desc.label = "background";
    desc.fragmentShader = "passes/lighting/background.frag";
    desc.defines = backgroundDefines;
    desc.depthTest = CompareOp::greaterOrEqual;
    auto background = device_.createPipeline(desc);
    if (!background) return tl::unexpected(background.error());
    entry.lighting = *lighting;
    entry.background = *background;
    entries_.push_back(entry);
    return entry;
}

Result<LightingPass::Outputs> LightingPass::add(FramePlan& plan, const Inputs& inputs) {
    const auto entry = find(inputs);
    if (!entry) return tl::unexpected(entry.error());
    Outputs out;
    const bool whole = inputs.part == LightingPart::all;
    out.radiance = plan.createImage(
        {whole ? "radiance" : toText(inputs.part), Format::rgba16f, inputs.width, inputs.height});
    const GBufferPass::Outputs& g = inputs.gbuffer;
    const bool background = hasBackground(inputs.part);
    PassBuilder pass = plan.addPass(whole ? "lighting" : "lighting.part");
    pass.color(out.radiance, background ? LoadOp::discard : LoadOp::clear, {0, 0, 0, 1});
    pass.depthTest(g.depth);
    LitScreenBindings{
        g, inputs.lighting, inputs.ambientOcclusion, inputs.localTint, inputs.localFlow, nearest_}
        .bind(pass);
    if (background) pass.texture(RL_TEXTURE_SKY, inputs.lighting.sky, inputs.lighting.cubeSampler);
    pass.record<Payload>({entry->lighting, background ? entry->background : PipelineHandle{}},
                         record);
    return out;
}

}  // namespace rushlight

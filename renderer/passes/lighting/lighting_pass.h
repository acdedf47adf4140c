#pragma once
// Scene lighting: the G-buffer under suns, clustered lights, shadows and the ambient term, and the
// background behind.

#include "renderer/frame/frame_settings.h"
#include "renderer/lighting/clusters/light_clusters.h"
#include "renderer/passes/surface/gbuffer_pass.h"
#include "renderer/plan/frame_plan.h"

#include <string_view>
#include <vector>

namespace rushlight {

/// Which features the lighting shaders have this frame; deferred and forward are compiled for the
/// same.
struct LightingFeatures {
    uint32_t directionalLights = 0;
    uint32_t shadowCascades = 0;   ///< 0: the sun casts none
    uint32_t secondSuns = 0;       ///< others that cast
    uint32_t secondCascades = 0;   ///< of each of them
    bool plainLights = false;      ///< LightClass::plain, in the froxels' lists
    bool modulatedLights = false;  ///< LightClass::modulated
    bool punctualShadow = false;   ///< some of them have shadow records
    bool lightPatterns = false;    ///< some of them have profiles or cookies
    ShadowFilter shadowFilter = ShadowFilter::pcf;
    bool environment = false;
    bool hemisphere = false;
    bool orthographic = false;
    bool irradianceVolume = false;  ///< the environment's irradiance, or the hemisphere, is not
                                    ///< read then

    bool reflectionProbes = false;   ///< before the environment, the hemisphere or the irradiance
                                     ///< volume
    bool ambientReflections = true;  ///< FrameSettings::ambientReflections
    bool areaLights = false;         ///< LightClass::area
    bool areaShadow = false;         ///< some of them have shadow records
    bool sunGlass = false;           ///< light of suns goes through what colours it
    bool atlasGlass = false;         ///< light of others
    bool clusteredLights() const { return plainLights || modulatedLights || areaLights; }
    bool operator==(const LightingFeatures&) const = default;
    /// The #defines; the texts are static.
    void appendDefines(std::vector<std::string_view>& defines) const;
};

/// What lighting shaders read besides the surface.
struct LightingBindings {
    LightingFeatures features;
    BufferRange uniforms;  ///< interop::LightingUniforms
    BufferRange lights, clusters, lightIndices;
    ImageId shadowMap;             ///< null without shadows
    ImageId shadowAtlas;           ///< of all but the suns; null when none has a shadow
    ImageId sunGlass, atlasGlass;  ///< with those features: what colours light, as ShadowGlass
                                   ///< keeps it
    BufferRange shadowFaces;       ///< GpuSecondSun, then GpuShadowFace
    SamplerHandle shadowSampler;
    TextureHandle environment;  ///< prefiltered cube
    TextureHandle irradiance;   ///< cube
    TextureHandle sky;          ///< sharp cube
    SamplerHandle cubeSampler;
    TextureHandle brdfTable;
    TextureHandle ltcTable;       ///< where there are area lights
    TextureHandle lightPatterns;  ///< where lights have profiles or cookies
    SamplerHandle patternSampler;
    SamplerHandle linearSampler;
    TextureHandle probeDistances;  ///< with an irradiance volume
    BufferRange probeRecords;
    TextureHandle reflectionCubes, reflectionIrradiance;  ///< with reflection probes: arrays
    BufferRange reflectionRecords;

    void bind(PassBuilder& pass) const;
    /// The irradiance volume itself, for passes that look it up.
    void bindProbes(PassBuilder& pass) const;
};

/// What a full-screen pass reads to light the surfaces of the G-buffer, or to light them otherwise
/// afterwards.
struct LitScreenBindings {
    GBufferPass::Outputs gbuffer;
    LightingBindings lighting;
    ImageId ambientOcclusion;      ///< null: the ambient light is open
    ImageId localTint, localFlow;  ///< with an irradiance volume
    SamplerHandle nearest;

    void bind(PassBuilder& pass) const;
};

/// What of the lit radiance is drawn; all of it in any frame that is meant to be seen.
enum class LightingPart : uint8_t { all, untextured, direct, ambient, ambientShare, emission };
const char* toText(LightingPart part);  ///< as its image is published; "lighting" for all

class LightingPass {
public:
    struct Inputs {
        GBufferPass::Outputs gbuffer;
        LightingBindings lighting;
        ImageId ambientOcclusion;      ///< GtaoPass::Outputs; null: the ambient light is open
        ImageId localTint, localFlow;  ///< of IrradiancePass; with an irradiance volume
        bool showSky = false;
        uint32_t width = 0, height = 0;
        bool sunContact = false;    ///< contact shadows of the first directional light, which casts
        bool lightContact = false;  ///< and of lights with a shadow record
        LightingPart part = LightingPart::all;
    };
    struct Outputs {
        ImageId radiance;  ///< RGBA16F, linear; alpha 0 where a transparent background shows
    };

    explicit LightingPass(Device& device);
    Result<Outputs> add(FramePlan& plan, const Inputs& inputs);

private:
    struct Entry {
        LightingFeatures features;
        bool ambientOcclusion, showSky, sunContact, lightContact;
        LightingPart part;
        PipelineHandle lighting, background;
    };
    Result<Entry> find(const Inputs&);

    Device& device_;
    SamplerHandle nearest_;
    std::vector<Entry> entries_;
};

}  // namespace rushlight

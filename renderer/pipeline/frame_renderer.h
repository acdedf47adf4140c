#pragma once
// One frame from FrameInput to a report: resolve, cull, list, light, plan, record, execute.

#include "engine/core/log.h"
#include "renderer/frame/frame_input.h"
#include "renderer/frame/frame_options.h"
#include "renderer/frame/instance_facts.h"
#include "renderer/lighting/clusters/decal_clusters.h"
#include "renderer/lighting/clusters/light_clusters.h"
#include "renderer/passes/blend/forward_pass.h"
#include "renderer/passes/debug/bounds_pass.h"
#include "renderer/passes/debug/debug_view_pass.h"
#include "renderer/passes/debug/overdraw_pass.h"
#include "renderer/passes/debug/overlay_pass.h"
#include "renderer/passes/lighting/irradiance_pass.h"
#include "renderer/passes/lighting/lighting_pass.h"
#include "renderer/passes/post/bloom_pass.h"
#include "renderer/passes/post/exposure_pass.h"
#include "renderer/passes/post/fxaa_pass.h"
#include "renderer/passes/post/tonemap_pass.h"
#include "renderer/passes/screen/fog_pass.h"
#include "renderer/passes/screen/gtao_pass.h"
#include "renderer/passes/screen/pyramid_pass.h"
#include "renderer/passes/screen/reflections_pass.h"
#include "renderer/passes/shadow/shadow_atlas_pass.h"
#include "renderer/passes/shadow/shadow_glass_pass.h"
#include "renderer/passes/shadow/shadow_pass.h"
#include "renderer/passes/surface/gbuffer_pass.h"
#include "renderer/pipeline/submitted_frames.h"
#include "renderer/plan/final_target.h"
#include "renderer/plan/frame_plan.h"
#include "renderer/resources/environment_store.h"
#include "renderer/resources/irradiance_store.h"
#include "renderer/resources/light_pattern_store.h"
#include "renderer/resources/reflection_store.h"
#include "renderer/rhi/commands/validate_commands.h"
#include "renderer/rhi/device.h"
#include "renderer/shadows/second_suns.h"
#include "renderer/shadows/shadow_schedule.h"
#include "renderer/visibility/host_worlds.h"
#include "renderer/visibility/visibility.h"

#include <array>

namespace rushlight {

/// What becomes of the picture.
struct FrameOutput {
    FrameTarget target;      ///< size; and the framebuffer when not `offscreen`
    bool offscreen = false;  ///< into an image that is read back under `ticket`
    bool hdr = false;        ///< read the linear radiance back instead of the display image
    uint32_t ticket = 0;
};

class FrameRenderer {
public:
    FrameRenderer(Device& device, JobSystem& jobs, LogSink log, std::string cacheDirectory);

    GeometryStore geometry;
    TextureStore textures;
    MaterialStore materials;
    DecalStore decals;
    LightPatternStore lightPatterns;
    EnvironmentStore environments;
    ReflectionStore reflections;
    IrradianceStore irradianceVolumes;
    HostWorlds worlds;

    Result<void> createMeshes(std::span<const MeshDesc> meshes, std::span<MeshHandle> handles) {
        return geometry.create(meshes, handles, jobs_);
    }
    Result<void> render(const FrameInput&, const FrameOutput&, const FrameOptions&);
    void forgetCaches() {
        shadowPass_.forget();
        shadowAtlasPass_.forget();
        shadowGlassPass_.forget();
        shadowLights_.forget();
    }
    void setValidation(bool on) { validates_ = on; }

    const FrameReport& report();
    std::vector<InstanceFacts> describeInstances() const;
    const CommandBuffer& commands() const { return submitted_.newestCommands(); }

private:
    Result<void> checkInput(const FrameInput&, const FrameOutput&) const;
    Result<void> checkPatterns(std::span<const PunctualLight>) const;
    Result<void> prepareResources();
    void prepareWorlds(const FrameInput&);
    void gatherViews(const FrameInput&, const FrameOutput&, const CameraMatrices&);
    void fillLists();
    void planShadows(const FrameInput&, const CameraMatrices&);
    void planLightShadows(const FrameInput&, const FrameOutput&, const CameraMatrices&);
    Result<void> addSunShadowPass(const FrameInput&, LightingBindings&);
    void bindShadowRecords(LightingBindings&);
    Result<void> addShadowPasses(const FrameInput&, LightingBindings&);
    Result<void> addLightShadowPass(LightingBindings&);
    Result<void> addSunGlassPass(const FrameInput&, LightingBindings&);
    Result<void> addLightGlassPass(LightingBindings&);
    Result<void> planPasses(const FrameInput&, const FrameOutput&, const CameraMatrices&);
    Result<LightingBindings> bindLighting(const FrameInput&, const CameraMatrices&,
                                          const FrameOutput&);
    DecalBindings bindDecals(const FrameInput&, const FrameOutput&, const CameraMatrices&,
                             interop::ViewUniforms&);
    /// Fog over the lit scene; a null image without. Where the fog is shown: that, over black.
    Result<ImageId> planFog(const FrameInput&, const LightingBindings&, ImageId radiance,
                            ImageId depth);
    /// The image that an HDR capture reads back.
    Result<ImageId> planLinearCapture(const FrameInput&, const FrameOutput&, ImageId radiance,
                                      ImageId depth);
    /// What follows the deferred lighting, up to the radiance that is displayed.
    Result<ImageId> planOverLighting(const FrameInput&, const CameraMatrices&,
                                     const LightingPass::Inputs&, ImageId radiance,
                                     BufferRange viewUniforms, const DecalBindings&);
    Result<void> planOverdraw(const FrameInput&, const FinalTarget&, const CameraMatrices&,
                              BufferRange viewUniforms);
    FinalTarget planTarget(const FrameOutput&);
    /// From linear radiance to the final target.
    Result<void> planDisplay(const FrameInput&, const FinalTarget&, ImageId radiance);
    Result<void> planDebugView(const FrameInput&, const FinalTarget&, const CameraMatrices&,
                               const GBufferPass::Outputs&, const LightingBindings&,
                               ImageId ambientOcclusion);
    /// A null image where the frame has no use for it.
    Result<ImageId> planAmbientOcclusion(const FrameInput&, const CameraMatrices&,
                                         const GBufferPass::Outputs&, const LightingBindings&,
                                         const FrameTarget&);
    /// The lit radiance with reflections in it, as far as they are wanted; or, to be shown, they
    /// alone.
    Result<ImageId> planReflections(const FrameInput&, const CameraMatrices&,
                                    const LightingPass::Inputs&, ImageId radiance);
    Result<void> validateCommands();
    Result<void> checkExecuted();
    void fillReport(const FrameInput&);
    void describePasses(SubmittedFrame&) const;
    template <class T>
    BufferRange uniforms(const T& value) {
        return commands_.append(std::span<const T>(&value, 1));
    }

    Device& device_;
    JobSystem& jobs_;
    LogSink log_;
    FramePlan plan_;
    GBufferPass gbufferPass_;
    GtaoPass gtaoPass_;
    PyramidPass pyramidPass_;
    ReflectionsPass reflectionsPass_;
    ShadowPass shadowPass_;
    ShadowAtlasPass shadowAtlasPass_;
    ShadowGlassPass shadowGlassPass_;
    IrradiancePass irradiancePass_;
    LightingPass lightingPass_;
    FogPass fogPass_;
    ForwardPass forwardPass_;
    BloomPass bloomPass_;
    ExposurePass exposurePass_;
    TonemapPass tonemapPass_;
    FxaaPass fxaaPass_;
    DebugViewPass debugViewPass_;
    BoundsPass boundsPass_;
    OverdrawPass overdrawPass_;
    OverlayPass overlayPass_;
    SamplerHandle shadowSampler_, cubeSampler_, linearSampler_, decalSampler_;

    CommandBuffer commands_;
    CommandValidator validator_;
    bool validates_ = false;
    SubmittedFrames submitted_;
    FrameReport report_;
    std::vector<PassReport> sparePassReports_;
    InstanceWorld frameInstances_;  ///< of FrameInput::instances
    FrameWorlds frameWorlds_;
    WorldHandle lastWorld_;  ///< which of the host's that was, if it still lives
    Visibility visibility_;
    Visibility::Lists lists_;
    Visibility::Counts counts_;
    ShadowCascades cascades_;
    SecondSuns secondSuns_;
    std::array<ShadowPass::View, ShadowPass::kMaxViews> sunViews_;
    uint32_t sunViewCount_ = 0;
    std::array<ShadowGlassPass::SunView, ShadowPass::kMaxViews> sunGlassViews_;
    ShadowGlassPass::SunOutputs sunGlass_;
    std::vector<GpuShadowFace> shadowRecords_;  ///< where there are second suns
    FogGrid fogGrid_;
    DecalClusters decalClusters_;
    LightClusters clusters_;
    int sun_ = -1;
    bool warnedRejected_ = false;
    ShadowPass::Outputs shadows_;
    ShadowLights shadowLights_;
    ShadowSchedule shadowSchedule_;
    ShadowLights::Counts shadowLightCounts_;
    std::vector<DrawList*> drawnLists_;
    std::vector<uint32_t> firstFillJobs_;  ///< of drawnLists_, and the end
    ImageId capturedImage_;
    uint64_t frameNumber_ = 0;
};

}  // namespace rushlight

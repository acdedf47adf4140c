#pragma once
// A scene, loaded and ready to be rendered as the options say.

#include "engine/assets/model.h"
#include "renderer/lighting/environment/sky.h"
#include "renderer/raytrace/probe_bake.h"
#include "renderer/renderer.h"
#include "renderer/scene_bridge/scene_bridge.h"
#include "renderer/scene_bridge/scene_defaults.h"
#include "sandbox/tool/options.h"

#include <memory>

namespace rushlight::tool {

class RenderSetup {
public:
    static Result<std::unique_ptr<RenderSetup>> open(const RenderOptions& options,
                                                     bool pinRasterThreads);
    /// With the null backend: needs no context and draws nothing.
    static Result<std::unique_ptr<RenderSetup>> openToBake(const RenderOptions& options);
    ~RenderSetup();

    Result<IrradianceVolume> bakeProbes();

    /// Moves the animation that --animation names; without one nothing moves.
    Result<void> setTime(float seconds);

    /// The frame as the options ask for it. Its spans are good until the next setTime.
    FrameInput frame() const;

    /// Of FrameInput::instances.
    ObjectNames objectNames(uint32_t instance) const { return bridge_->objectNames(instance); }

    Renderer& renderer() { return *renderer_; }
    ContextKind contextKind() const { return context_->kind(); }
    uint32_t threads() const { return jobs_->concurrency(); }
    double loadMs() const { return loadMs_; }
    const assets::Fidelity& fidelity() const { return model_.fidelity; }

private:
    explicit RenderSetup(const RenderOptions& options) : options_(options) {}
    Result<void> loadScene();
    Result<void> startRenderer(bool pinRasterThreads);
    Result<void> createRenderer(GlLoadFunction loader);  ///< and the bridge
    Result<void> loadEnvironment();
    Result<void> loadProbes();
    BakeLighting bakeLighting() const;
    Result<void> makeSkyEnvironment();
    Result<void> useEnvironment(const EnvironmentDesc&);
    Result<void> useFileEnvironment(const assets::ImageBasedLight&);
    Result<void> captureReflections();
    Result<void> chooseCamera();
    void chooseLights();

    // Destroyed from the last to the first: the resources before the renderer, and it before its
    // context.
    RenderOptions options_;
    assets::Model model_;
    std::unique_ptr<JobSystem> jobs_;
    std::unique_ptr<Context> context_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<SceneBridge> bridge_;
    EnvironmentHandle environment_;
    std::vector<vec3> environmentPixels_;  ///< kept where probes are baked or checked
    uvec2 environmentSize_{0};
    float fileIntensity_ = 1;  ///< of the environment, where it is the file's
    IrradianceVolumeHandle probes_;
    std::optional<Sky> sky_;  ///< of --sky
    int animation_ = -1;
    int camera_ = -1;  ///< -1: `view_`
    View view_;
    bool hasEnvironment_ = false;
    std::optional<DefaultLights> defaultLights_;
    double loadMs_ = 0;
};

}  // namespace rushlight::tool

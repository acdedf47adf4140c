#pragma once
// Frames of a scene file, for tests that look at pictures.

#include "engine/assets/model.h"
#include "renderer/renderer.h"
#include "renderer/scene_bridge/scene_bridge.h"
#include "renderer/scene_bridge/scene_defaults.h"

#include <memory>
#include <string>

namespace rushlight {

/// What a picture shows, beside the scene.
struct SceneView {
    std::string camera;  ///< by name; empty: the first of the file, else one that frames the scene
    uint32_t width = 320;
    uint32_t height = 180;
    FrameSettings settings;
};

/// A scene file in a renderer, with the image-based light and the reflection probes that the file
/// has; without lights and environment it gets those of scene_defaults.h. Baked light, which lies
/// in a file beside it, is not used: `rushlight check` knows it.
class SceneFrames {
public:
    /// Loads and uploads the scene; `environment` is an .hdr or .exr file, or empty: the file's
    /// own, if it has one. Reflection probes are captured now, in the scene's first pose.
    /// `renderer` must outlive this.
    static Result<std::unique_ptr<SceneFrames>> open(Renderer& renderer, const std::string& scene,
                                                     const std::string& environment);
    ~SceneFrames();

    /// The input of a frame; its spans are good until the next call.
    Result<void> fill(const SceneView& view, FrameInput& input);
    Result<CapturedImage> render(const SceneView& view, const FrameOptions& options = {});
    Renderer& renderer() const { return renderer_; }

private:
    explicit SceneFrames(Renderer& renderer) : renderer_(renderer) {}
    Result<void> loadEnvironment(const std::string& path);
    Result<void> loadSurroundings();
    Result<View> viewOf(const SceneView& view) const;

    Renderer& renderer_;
    assets::Model model_;
    std::unique_ptr<SceneBridge> bridge_;
    EnvironmentHandle environment_;
    float environmentIntensity_ = 1;
    DefaultLights lights_;
};

}  // namespace rushlight

#pragma once
// A scene file in a renderer of its own, without the command-line tool, for tests that look at pictures.

#include "engine/assets/model.h"
#include "renderer/capture/picture.h"
#include "renderer/renderer.h"
#include "renderer/scene_bridge/scene_bridge.h"

#include <memory>
#include <string>

namespace rushlight {

/// What a picture shows, beside the scene.
struct SceneView {
    std::string camera;       ///< by name; empty: the first of the file, else one that frames the scene
    uint32_t width = 320;
    uint32_t height = 180;
    FrameSettings settings;
};

class SceneFrames {
public:
    /// Loads and uploads the scene; `environment` is an .hdr or .exr file, or empty. `renderer` must outlive this.
    static Result<std::unique_ptr<SceneFrames>> open(Renderer& renderer, const std::string& scene,
                                                     const std::string& environment);
    ~SceneFrames();

    /// The input of a frame; its spans stay good while this lives.
    Result<void> fill(const SceneView& view, FrameInput& input) const;
    Result<CapturedImage> render(const SceneView& view, const FrameOptions& options = {});

private:
    explicit SceneFrames(Renderer& renderer) : renderer_(renderer) {}
    Result<void> loadEnvironment(const std::string& path);
    Result<View> viewOf(const SceneView& view) const;

    Renderer& renderer_;
    assets::Model model_;
    std::unique_ptr<SceneBridge> bridge_;
    EnvironmentHandle environment_;
};

/// As a file with these pixels reads; only of opaque pictures.
Picture pictureOf(const CapturedImage& image);

}  // namespace rushlight

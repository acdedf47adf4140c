#include "renderer/testing/scene_frames.h"

#include "engine/assets/gltf.h"
#include "renderer/capture/image_files.h"
#include "renderer/scene_bridge/scene_defaults.h"
#include "renderer/scene_bridge/scene_surroundings.h"

namespace rushlight {

Result<std::unique_ptr<SceneFrames>> SceneFrames::open(Renderer& renderer, const std::string& scene,
                                                       const std::string& environment) {
    std::unique_ptr<SceneFrames> frames(new SceneFrames(renderer));
    auto model = assets::loadModel(scene);
    if (!model) return tl::unexpected(model.error());
    frames->model_ = std::move(*model);
    auto bridge = SceneBridge::create(renderer, frames->model_);
    if (!bridge) return tl::unexpected(bridge.error());
    frames->bridge_ = std::move(*bridge);
    const auto loaded = environment.empty() ? frames->loadSurroundings()
                                            : frames->loadEnvironment(environment);
    if (!loaded) return tl::unexpected(loaded.error());
    if (!frames->bridge_->hasReflectionProbes()) return frames;
    FrameInput input;
    if (auto filled = frames->fill({}, input); !filled) return tl::unexpected(filled.error());
    if (auto captured = frames->bridge_->captureReflections(input); !captured)
        return tl::unexpected(captured.error());
    return frames;
}

SceneFrames::~SceneFrames() {
    if (environment_) renderer_.destroy(environment_);
}

Result<void> SceneFrames::loadEnvironment(const std::string& path) {
    const auto picture = loadPicture(path);
    if (!picture) return tl::unexpected(picture.error());
    if (!picture->linear)
        return fail(path, "An environment is linear radiance in floats; use a .hdr or .exr file.");
    std::vector<vec3> pixels(picture->pixelCount());
    for (size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = {picture->rgba[i * 4], picture->rgba[i * 4 + 1], picture->rgba[i * 4 + 2]};
    EnvironmentDesc desc;
    desc.label = path;
    desc.width = picture->width;
    desc.height = picture->height;
    desc.pixels = pixels;
    const auto created = renderer_.createEnvironment(desc);
    if (!created) return tl::unexpected(created.error());
    environment_ = *created;
    return {};
}

Result<void> SceneFrames::loadSurroundings() {
    if (!model_.imageBasedLight) return {};
    const auto created = renderer_.createPrefilteredEnvironment(
        environmentOf(*model_.imageBasedLight));
    if (!created) return tl::unexpected(created.error());
    environment_ = *created;
    environmentIntensity_ = model_.imageBasedLight->intensity;
    return {};
}

Result<View> SceneFrames::viewOf(const SceneView& wanted) const {
    for (size_t i = 0; i < model_.cameras.size(); ++i) {
        if (!wanted.camera.empty() && model_.cameras[i].name != wanted.camera) continue;
        if (const auto view = bridge_->cameraView(int(i))) return *view;
    }
    if (wanted.camera.empty())
        return viewThatFrames(bridge_->bounds(), View{}.verticalFov,
                              float(wanted.width) / float(wanted.height));
    return fail(model_.path, "There is no camera \"" + wanted.camera + "\" in a node.");
}

Result<void> SceneFrames::fill(const SceneView& wanted, FrameInput& input) {
    bridge_->fill(input);
    const auto view = viewOf(wanted);
    if (!view) return tl::unexpected(view.error());
    input.view = *view;
    input.settings = wanted.settings;
    input.lighting.environment = environment_;
    input.lighting.environmentIntensity = environmentIntensity_;
    if (environment_) input.lighting.background = Background::environment;
    if (environment_ || bridge_->hasLights()) return {};
    lights_ = defaultLights(*view);
    input.lighting.directional = {&lights_.sun, 1};
    input.lighting.ambientSky = lights_.ambientSky;
    input.lighting.ambientGround = lights_.ambientGround;
    return {};
}

Result<CapturedImage> SceneFrames::render(const SceneView& wanted, const FrameOptions& options) {
    FrameInput input;
    if (auto filled = fill(wanted, input); !filled) return tl::unexpected(filled.error());
    const auto ticket = renderer_.renderOffscreen(input, wanted.width, wanted.height,
                                                  CaptureKind::display, options);
    if (!ticket) return tl::unexpected(ticket.error());
    CapturedImage image;
    if (!renderer_.takeCapture(*ticket, true, image))
        return fail("capture", "It did not arrive although it was waited for.");
    return image;
}

}  // namespace rushlight

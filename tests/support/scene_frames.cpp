#include "tests/support/scene_frames.h"

#include "engine/assets/gltf.h"
#include "renderer/capture/image_files.h"

#include <algorithm>

namespace rushlight {
namespace {

/// The whole scene, from the front and a little from above.
View framing(const Aabb& bounds) {
    const vec3 center = bounds.isEmpty() ? vec3(0) : bounds.center();
    const float radius =
        bounds.isEmpty() ? 1.0f : std::max(glm::length(bounds.halfExtent()), 1e-4f);
    View view;
    const float distance = radius / std::sin(view.verticalFov / 2);
    const vec3 eye = center + distance * glm::normalize(vec3(0.35f, 0.3f, 1));
    view.viewFromWorld = glm::lookAt(eye, center, vec3(0, 1, 0));
    view.nearPlane = distance * 0.01f;
    return view;
}

const DirectionalLight kSun{glm::normalize(vec3(-0.3f, -1, -0.5f)), vec3(3), true};

}  // namespace

Result<std::unique_ptr<SceneFrames>> SceneFrames::open(Renderer& renderer, const std::string& scene,
                                                       const std::string& environment) {
    std::unique_ptr<SceneFrames> frames(new SceneFrames(renderer));
    auto model = assets::loadModel(scene);
    if (!model) return tl::unexpected(model.error());
    frames->model_ = std::move(*model);
    auto bridge = SceneBridge::create(renderer, frames->model_);
    if (!bridge) return tl::unexpected(bridge.error());
    frames->bridge_ = std::move(*bridge);
    if (environment.empty()) return frames;
    if (auto loaded = frames->loadEnvironment(environment); !loaded)
        return tl::unexpected(loaded.error());
    return frames;
}

SceneFrames::~SceneFrames() {
    if (environment_) renderer_.destroy(environment_);
}

Result<void> SceneFrames::loadEnvironment(const std::string& path) {
    const auto picture = loadPicture(path);
    if (!picture) return tl::unexpected(picture.error());
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

Result<View> SceneFrames::viewOf(const SceneView& wanted) const {
    for (size_t i = 0; i < model_.cameras.size(); ++i) {
        if (!wanted.camera.empty() && model_.cameras[i].name != wanted.camera) continue;
        if (const auto view = bridge_->cameraView(int(i))) return *view;
    }
    if (wanted.camera.empty()) return framing(bridge_->bounds());
    return fail(model_.path, "There is no camera \"" + wanted.camera + "\" in a node.");
}

Result<void> SceneFrames::fill(const SceneView& wanted, FrameInput& input) const {
    bridge_->fill(input);
    const auto view = viewOf(wanted);
    if (!view) return tl::unexpected(view.error());
    input.view = *view;
    input.settings = wanted.settings;
    input.lighting.environment = environment_;
    if (environment_) input.lighting.background = Background::environment;
    if (!environment_ && !bridge_->hasLights()) {
        input.lighting.directional = {&kSun, 1};
        input.lighting.ambientSky = input.lighting.ambientGround = vec3(0.3f);
    }
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

Picture pictureOf(const CapturedImage& image) {
    Picture picture;
    picture.width = image.width;
    picture.height = image.height;
    picture.rgba.resize(image.rgba8.size());
    std::ranges::transform(image.rgba8, picture.rgba.begin(),
                           [](uint8_t value) { return float(value) / 255.0f; });
    return picture;
}

}  // namespace rushlight

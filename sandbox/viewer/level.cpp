#include "sandbox/viewer/level.h"

#include "engine/assets/gltf.h"
#include "engine/scene/pose.h"
#include "renderer/scene_bridge/scene_bridge.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace rushlight {
namespace {

/// The number that all of `text` is, or -1.
int indexFrom(std::string_view text) {
    int index = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    return error == std::errc() && end == text.data() + text.size() ? index : -1;
}

LevelCamera cameraFrom(const View& view) {
    const mat4 world = glm::inverse(view.viewFromWorld);
    LevelCamera camera;
    camera.position = vec3(world[3]);
    camera.forward = -vec3(world[2]);
    camera.perspective = view.perspective;
    camera.verticalFov = view.verticalFov;
    camera.orthoHalfHeight = view.orthoHalfHeight;
    camera.nearPlane = view.nearPlane;
    camera.farPlane = view.farPlane;
    return camera;
}

}  // namespace

struct Level::Scene {
    assets::Model model;
    scene::Pose rest;
    std::unique_ptr<SceneBridge> bridge;
    FrameInput frame;  ///< the spans of the bridge
    std::vector<PunctualLight> punctual;
    std::vector<std::string> punctualNames;

    void refill();
    void nameLights();
};

void Level::Scene::refill() {
    bridge->fill(frame);
    punctual.assign(frame.lighting.punctual.begin(), frame.lighting.punctual.end());
}

/// A light is known by its place: the node nearest to it that carries one.
void Level::Scene::nameLights() {
    for (const PunctualLight& light : punctual) {
        float nearest = INFINITY;
        std::string name;
        for (size_t i = 0; i < model.nodes.size(); ++i) {
            if (model.nodes[i].light < 0) continue;
            const float distance = glm::distance(vec3(rest.worldFromNode[i][3]), light.position);
            if (distance >= nearest) continue;
            nearest = distance;
            name = model.nodes[i].name;
        }
        punctualNames.push_back(std::move(name));
    }
}

Level::Level() : scene_(std::make_unique<Scene>()) {}
Level::~Level() = default;

Result<std::unique_ptr<Level>> Level::load(const std::string& path, Renderer& renderer,
                                           JobSystem* jobs) {
    assets::LoadOptions options;
    options.jobs = jobs;
    auto model = assets::loadModel(path, options);
    if (!model) return tl::unexpected(model.error());
    std::unique_ptr<Level> level(new Level);
    Scene& scene = *level->scene_;
    scene.model = std::move(*model);
    scene.rest = scene::restPose(scene.model);
    auto bridge = SceneBridge::create(renderer, scene.model);
    if (!bridge) return tl::unexpected(bridge.error());
    scene.bridge = std::move(*bridge);
    scene.refill();
    scene.nameLights();
    return level;
}

Result<void> Level::advanceTo(double seconds) {
    Scene& s = *scene_;
    if (!s.model.animations.empty()) {
        const float duration = s.model.animations[0].duration;
        const double time = duration > 0 ? std::fmod(seconds, double(duration)) : 0;
        if (auto posed = s.bridge->pose(0, float(time)); !posed) return posed;
    }
    s.refill();
    return {};
}

const assets::Model& Level::model() const { return scene_->model; }
std::span<const Instance> Level::instances() const { return scene_->frame.instances; }
std::span<const mat4x3> Level::previousTransforms() const {
    return scene_->frame.previousTransforms;
}
std::span<const DirectionalLight> Level::directionalLights() const {
    return scene_->frame.lighting.directional;
}
std::span<const ReflectionProbe> Level::reflectionProbes() const {
    return scene_->frame.lighting.reflectionProbes;
}
Result<void> Level::captureReflections(const FrameInput& input) {
    if (!scene_->bridge->hasReflectionProbes()) return {};
    if (auto done = scene_->bridge->captureReflections(input); !done) return done;
    scene_->refill();
    return {};
}
std::span<PunctualLight> Level::punctualLights() { return scene_->punctual; }
const std::string& Level::punctualName(size_t index) const { return scene_->punctualNames[index]; }
Aabb Level::bounds() const { return scene_->bridge->bounds(); }

const TriangleGrid& Level::collision() {
    if (!collision_) collision_.emplace(collisionTriangles(scene_->model));
    return *collision_;
}

std::optional<mat4> Level::nodeNamed(std::string_view name) const {
    const auto& nodes = scene_->model.nodes;
    for (size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].name == name) return scene_->rest.worldFromNode[i];
    return std::nullopt;
}

std::optional<LevelCamera> Level::camera(std::string_view name) const {
    const assets::Model& model = scene_->model;
    int index = name.empty() ? 0 : indexFrom(name);
    for (size_t i = 0; i < model.cameras.size(); ++i)
        if (!name.empty() && model.cameras[i].name == name) index = int(i);
    for (const assets::Node& node : model.nodes)
        if (!name.empty() && node.name == name && node.camera >= 0) index = node.camera;
    if (index < 0 || size_t(index) >= model.cameras.size()) return std::nullopt;
    const auto view = scene_->bridge->cameraView(index);
    if (!view) return std::nullopt;
    return cameraFrom(*view);
}

LevelCamera Level::framingCamera() const {
    LevelCamera camera;
    const Aabb box = bounds();
    if (box.isEmpty()) return camera;
    const float radius = std::max(glm::length(box.halfExtent()), 1e-3f);
    camera.forward = glm::normalize(vec3(-0.4f, -0.35f, -1));
    camera.position = box.center() -
                      camera.forward * (1.05f * radius / std::sin(0.5f * camera.verticalFov));
    camera.nearPlane = 0.01f * radius;
    return camera;
}

}  // namespace rushlight

#include "renderer/scene_bridge/scene_bridge.h"

#include "engine/core/check.h"
#include "engine/scene/deform.h"
#include "engine/scene/pose.h"
#include "renderer/scene_bridge/light_uploads.h"
#include "renderer/scene_bridge/materials.h"
#include "renderer/scene_bridge/scene_lights.h"
#include "renderer/scene_bridge/scene_surroundings.h"

#include <algorithm>

namespace rushlight {
namespace {

MeshDesc meshDesc(const assets::Geometry& geometry) {
    MeshDesc desc;
    desc.label = geometry.name;
    desc.positions = geometry.positions;
    desc.normals = geometry.normals;
    desc.tangents = geometry.tangents;
    desc.uv0 = geometry.uv0;
    desc.uv1 = geometry.uv1;
    desc.colors = geometry.colors;
    desc.indices = geometry.indices;
    return desc;
}

}  // namespace

struct SceneBridge::State {
    State(Renderer& r, const assets::Model& m)
        : renderer(r), model(m), materials(r, m), uploads(r, m) {}
    ~State() {
        for (MeshHandle mesh : meshes) renderer.destroy(mesh);
        for (EnvironmentHandle captured : environments) renderer.destroy(captured);
    }

    Result<void> addInstances();
    Result<void> addInstance(const scene::Drawable&, MeshHandle);
    Result<void> createMeshes();
    Result<void> deform(size_t instance);
    MeshDesc deformedDesc(size_t instance);
    Result<void> describeMeshes(ResourceSink&);
    void move(size_t instance, const mat4x3& to);
    Result<void> setPose(scene::Pose);
    void placeProbes();
    Result<void> captureFirst(const FrameInput& seen);
    Result<void> captureAgain(const FrameInput& seen);

    Renderer& renderer;
    const assets::Model& model;
    MaterialUploads materials;
    LightUploads uploads;            ///< of profiles and cookies
    std::vector<MeshHandle> meshes;  ///< all that are to be destroyed
    std::vector<uint32_t> meshOf;    ///< as `drawables`: which of `meshes`

    scene::Pose now;
    int animation = -1;
    float seconds = 0;
    std::vector<int> nodes;                  ///< of the shown scene
    std::vector<scene::Drawable> drawables;  ///< as `instances`
    std::vector<Aabb> bounds;                ///< as `instances`, local, after deforming
    std::vector<Instance> instances;
    std::vector<mat4x3> previousTransforms;  ///< as `instances`
    SceneLights lights;
    std::vector<std::string> notes;
    std::vector<ReflectionProbe> probes;          ///< where nodes have them
    std::vector<CaptureDesc> captures;            ///< as `probes`
    std::vector<EnvironmentHandle> environments;  ///< as `probes`; empty: not captured yet
    scene::DeformedVertices scratch;
};

// One mesh per geometry, or per drawable where it deforms, all in one call.
Result<void> SceneBridge::State::createMeshes() {
    constexpr uint32_t kNone = ~0u;
    std::vector<uint32_t> shared(model.geometries.size(), kNone);
    std::vector<MeshDesc> descs;
    for (const scene::Drawable& drawable : drawables) {
        uint32_t own = kNone;
        uint32_t& mesh = drawable.deforms ? own : shared[size_t(drawable.geometry)];
        if (mesh == kNone) {
            mesh = uint32_t(descs.size());
            descs.push_back(meshDesc(model.geometries[size_t(drawable.geometry)]));
        }
        meshOf.push_back(mesh);
    }
    meshes.resize(descs.size());
    return renderer.createMeshes(descs, meshes);
}

Result<void> SceneBridge::State::addInstance(const scene::Drawable& drawable, MeshHandle mesh) {
    const auto material = materials.find(drawable.material);
    if (!material) return tl::unexpected(material.error());
    Instance instance;
    instance.worldFromLocal = drawable.worldFromLocal;
    instance.mesh = mesh;
    instance.material = *material;
    instance.id = uint32_t(instances.size());
    instance.previousTransform = instance.id;
    instances.push_back(instance);
    bounds.push_back(model.geometries[size_t(drawable.geometry)].bounds);
    return {};
}

Result<void> SceneBridge::State::addInstances() {
    now = scene::restPose(model);
    nodes = scene::reachableNodes(model);
    drawables = scene::listDrawables(model, now);
    if (auto created = uploads.create(); !created) return created;
    if (auto created = createMeshes(); !created) return created;
    for (size_t i = 0; i < drawables.size(); ++i)
        if (auto added = addInstance(drawables[i], meshes[meshOf[i]]); !added) return added;
    previousTransforms.resize(instances.size());
    return setPose(std::move(now));
}

/// In `scratch`.
MeshDesc SceneBridge::State::deformedDesc(size_t i) {
    const scene::Drawable& drawable = drawables[i];
    const assets::Geometry& geometry = model.geometries[size_t(drawable.geometry)];
    scene::applySkinAndMorph(model, now, drawable.node, geometry, scratch);
    MeshDesc desc = meshDesc(geometry);
    desc.positions = scratch.positions;
    desc.normals = scratch.normals;
    desc.tangents = scratch.tangents;
    return desc;
}

Result<void> SceneBridge::State::deform(size_t i) {
    const MeshDesc desc = deformedDesc(i);
    bounds[i] = {};
    for (const vec3& position : desc.positions) bounds[i].grow(position);
    return renderer.updateMesh(instances[i].mesh, desc);
}

Result<void> SceneBridge::State::describeMeshes(ResourceSink& sink) {
    std::vector<bool> done(meshes.size());
    for (size_t i = 0; i < drawables.size(); ++i) {
        if (done[meshOf[i]]) continue;
        done[meshOf[i]] = true;
        const MeshDesc desc = drawables[i].deforms
                                  ? deformedDesc(i)
                                  : meshDesc(model.geometries[size_t(drawables[i].geometry)]);
        if (auto ok = sink.mesh(meshes[meshOf[i]], desc); !ok) return ok;
    }
    return {};
}

void SceneBridge::State::move(size_t i, const mat4x3& to) {
    Instance& instance = instances[i];
    previousTransforms[i] = instance.worldFromLocal;
    instance.worldFromLocal = to;
    instance.flags = kInstanceCastsShadow;
    if (previousTransforms[i] != to) instance.flags |= kInstanceMoving;
}

Result<void> SceneBridge::State::setPose(scene::Pose pose) {
    now = std::move(pose);
    drawables = scene::listDrawables(model, now);
    RL_CHECK(drawables.size() == instances.size(), "a pose neither adds nor removes drawables");
    for (size_t i = 0; i < instances.size(); ++i) {
        if (drawables[i].deforms)
            if (auto deformed = deform(i); !deformed) return deformed;
        move(i, drawables[i].worldFromLocal);
    }
    lights = lightsOf(model, uploads, nodes, now.worldFromNode, notes);
    placeProbes();
    return {};
}

// A probe that an animation scales to nothing, or back, changes their number; then they are to be
// captured anew.
void SceneBridge::State::placeProbes() {
    probes = reflectionProbesOf(model, nodes, now.worldFromNode, captures, notes);
    if (environments.size() != probes.size()) {
        for (EnvironmentHandle captured : environments) renderer.destroy(captured);
        environments.clear();
    }
    for (size_t i = 0; i < environments.size(); ++i) probes[i].environment = environments[i];
}

SceneBridge::SceneBridge(std::unique_ptr<State> state) : state_(std::move(state)) {}
SceneBridge::~SceneBridge() = default;

Result<std::unique_ptr<SceneBridge>> SceneBridge::create(Renderer& renderer,
                                                         const assets::Model& model) {
    auto state = std::make_unique<State>(renderer, model);
    if (auto added = state->addInstances(); !added) return tl::unexpected(added.error());
    return std::unique_ptr<SceneBridge>(new SceneBridge(std::move(state)));
}

Result<void> SceneBridge::pose(int animation, float seconds) {
    State& s = *state_;
    RL_CHECK(animation < int(s.model.animations.size()), "the animation is one of the model");
    if (animation == s.animation && (animation < 0 || seconds == s.seconds)) {
        for (size_t i = 0; i < s.instances.size(); ++i) s.move(i, s.drawables[i].worldFromLocal);
        return {};
    }
    s.animation = animation;
    s.seconds = seconds;
    return s.setPose(scene::poseAt(s.model, animation, seconds));
}

void SceneBridge::fill(FrameInput& input) const {
    input.instances = state_->instances;
    input.previousTransforms = state_->previousTransforms;
    input.lighting.directional = state_->lights.directional;
    input.lighting.punctual = state_->lights.punctual;
    input.lighting.area = state_->lights.area;
    if (!state_->environments.empty()) input.lighting.reflectionProbes = state_->probes;
}

Result<void> SceneBridge::describe(ResourceSink& sink) const {
    if (auto ok = state_->materials.describe(sink); !ok) return ok;
    return state_->describeMeshes(sink);
}

const LightPatternSet& SceneBridge::lightPatterns() const { return state_->uploads.patterns(); }

Result<void> SceneBridge::State::captureFirst(const FrameInput& seen) {
    std::vector<EnvironmentHandle> made;
    for (size_t i = 0; i < probes.size(); ++i) {
        const auto captured = renderer.captureEnvironment(seen, probes[i].position, captures[i]);
        if (!captured) {
            for (EnvironmentHandle environment : made) renderer.destroy(environment);
            return tl::unexpected(captured.error());
        }
        made.push_back(*captured);
    }
    environments = std::move(made);
    for (size_t i = 0; i < probes.size(); ++i) probes[i].environment = environments[i];
    return {};
}

Result<void> SceneBridge::State::captureAgain(const FrameInput& seen) {
    for (size_t i = 0; i < probes.size(); ++i)
        if (auto done = renderer.recaptureEnvironment(environments[i], seen, probes[i].position,
                                                      captures[i]);
            !done)
            return done;
    return {};
}

// First as they are without any probes, then with the light that these give: what a mirror shows of
// a room would else be darker than the room is.
Result<void> SceneBridge::captureReflections(const FrameInput& input) {
    State& s = *state_;
    FrameInput seen = input;
    seen.lighting.reflectionProbes = {};
    const auto first = s.environments.empty() ? s.captureFirst(seen) : s.captureAgain(seen);
    if (!first) return first;
    seen.lighting.reflectionProbes = s.probes;
    return s.captureAgain(seen);
}

bool SceneBridge::hasReflectionProbes() const { return !state_->probes.empty(); }

bool SceneBridge::hasLights() const {
    return !state_->lights.directional.empty() || !state_->lights.punctual.empty() ||
           !state_->lights.area.empty();
}

ObjectNames SceneBridge::objectNames(uint32_t instance) const {
    RL_CHECK(instance < state_->drawables.size(), "the instance is one of the bridge's");
    const scene::Drawable& drawable = state_->drawables[instance];
    const assets::Model& model = state_->model;
    const assets::Node& node = model.nodes[size_t(drawable.node)];
    ObjectNames names{node.name, {}, {}};
    if (node.mesh >= 0) names.mesh = model.meshes[size_t(node.mesh)].name;
    if (drawable.material >= 0) names.material = model.materials[size_t(drawable.material)].name;
    return names;
}

Aabb SceneBridge::bounds() const {
    Aabb all;
    for (size_t i = 0; i < state_->instances.size(); ++i)
        if (!state_->bounds[i].isEmpty())
            all.grow(transformAabb(state_->instances[i].worldFromLocal, state_->bounds[i]));
    return all;
}

std::optional<View> SceneBridge::cameraView(int camera) const {
    for (int node : state_->nodes)
        if (state_->model.nodes[size_t(node)].camera == camera)
            return viewOf(state_->model.cameras[size_t(camera)],
                          state_->now.worldFromNode[size_t(node)]);
    return {};
}

const std::vector<std::string>& SceneBridge::notes() const { return state_->notes; }

}  // namespace rushlight

#include "renderer/scene_bridge/scene_bridge.h"

#include "engine/core/check.h"
#include "renderer/scene_bridge/deform.h"
#include "renderer/scene_bridge/materials.h"
#include "renderer/scene_bridge/pose.h"
#include "renderer/scene_bridge/scene_lights.h"

#include <algorithm>

namespace rushlight {
namespace {

mat4x3 affine(const mat4& m) { return mat4x3(m); }

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

/// What an Instance of the frame comes from.
struct Source {
    int node = -1;
    int geometry = -1;
    bool deformed = false;
    bool skinned = false;
    Aabb bounds;                 ///< local, after deforming
    std::vector<float> weights;  ///< that the mesh was last deformed with
    std::vector<mat4> joints;
};

}  // namespace

struct SceneBridge::State {
    State(Renderer& r, const assets::Model& m)
        : renderer(r), model(m), materials(r, m), nodes(shownNodes(m)) {}
    ~State() {
        for (MeshHandle mesh : meshes) renderer.destroy(mesh);
    }

    Result<void> addInstances();
    Result<void> addInstance(int node, const assets::Primitive&);
    Result<MeshHandle> findMesh(const Source&);
    Result<void> deformAgain(size_t instance, const std::vector<NodePose>&);
    void move(size_t instance, const mat4x3& to);
    std::vector<mat4> jointTransforms(int skin) const;

    Renderer& renderer;
    const assets::Model& model;
    MaterialUploads materials;
    std::vector<int> nodes;

    std::vector<MeshHandle> meshes;        ///< all that are to be destroyed
    std::vector<MeshHandle> sharedMeshes;  ///< by geometry; zero until used
    std::vector<Source> sources;           ///< as `instances`
    std::vector<Instance> instances;
    std::vector<mat4x3> previousTransforms;  ///< as `instances`
    std::vector<mat4> world;                 ///< by node
    SceneLights lights;
    std::vector<std::string> notes;
    DeformedVertices scratch;
    bool posed = false;
};

Result<MeshHandle> SceneBridge::State::findMesh(const Source& source) {
    MeshHandle& shared = sharedMeshes[size_t(source.geometry)];
    if (!source.deformed && shared) return shared;
    auto mesh = renderer.createMesh(meshDesc(model.geometries[size_t(source.geometry)]));
    if (!mesh) return mesh;
    meshes.push_back(*mesh);
    if (!source.deformed) shared = *mesh;
    return mesh;
}

Result<void> SceneBridge::State::addInstance(int node, const assets::Primitive& primitive) {
    const assets::Geometry& geometry = model.geometries[size_t(primitive.geometry)];
    Source source;
    source.node = node;
    source.geometry = primitive.geometry;
    source.skinned = model.nodes[size_t(node)].skin >= 0 && !geometry.skin.empty();
    source.deformed = source.skinned || !geometry.morphTargets.empty();
    source.bounds = geometry.bounds;
    const auto mesh = findMesh(source);
    if (!mesh) return tl::unexpected(mesh.error());
    const auto material = materials.find(primitive.material);
    if (!material) return tl::unexpected(material.error());

    Instance instance;
    instance.mesh = *mesh;
    instance.material = *material;
    instance.id = uint32_t(instances.size());
    instance.previousTransform = instance.id;
    instances.push_back(instance);
    sources.push_back(std::move(source));
    return {};
}

Result<void> SceneBridge::State::addInstances() {
    sharedMeshes.resize(model.geometries.size());
    for (int node : nodes) {
        const int mesh = model.nodes[size_t(node)].mesh;
        if (mesh < 0) continue;
        for (const assets::Primitive& primitive : model.meshes[size_t(mesh)].primitives)
            if (primitive.geometry >= 0)
                if (auto added = addInstance(node, primitive); !added) return added;
    }
    previousTransforms.resize(instances.size());
    return {};
}

std::vector<mat4> SceneBridge::State::jointTransforms(int index) const {
    const assets::Skin& skin = model.skins[size_t(index)];
    std::vector<mat4> transforms(skin.joints.size());
    for (size_t i = 0; i < transforms.size(); ++i) {
        transforms[i] = world[size_t(skin.joints[i])];
        if (i < skin.inverseBindMatrices.size())
            transforms[i] = transforms[i] * skin.inverseBindMatrices[i];
    }
    return transforms;
}

Result<void> SceneBridge::State::deformAgain(size_t i, const std::vector<NodePose>& poses) {
    Source& source = sources[i];
    const assets::Geometry& geometry = model.geometries[size_t(source.geometry)];
    const std::vector<float>& weights = poses[size_t(source.node)].weights;
    std::vector<mat4> joints;
    if (source.skinned) joints = jointTransforms(model.nodes[size_t(source.node)].skin);
    if (posed && weights == source.weights && joints == source.joints) return {};
    source.weights = weights;
    source.joints = std::move(joints);

    deform(geometry, source.weights, source.joints, scratch);
    MeshDesc desc = meshDesc(geometry);
    desc.positions = scratch.positions;
    desc.normals = scratch.normals;
    desc.tangents = scratch.tangents;
    source.bounds = {};
    for (const vec3& position : scratch.positions) source.bounds.grow(position);
    return renderer.updateMesh(instances[i].mesh, desc);
}

void SceneBridge::State::move(size_t i, const mat4x3& to) {
    Instance& instance = instances[i];
    previousTransforms[i] = posed ? instance.worldFromLocal : to;
    instance.worldFromLocal = to;
    instance.flags = kInstanceCastsShadow;
    if (previousTransforms[i] != to) instance.flags |= kInstanceMoving;
}

SceneBridge::SceneBridge(std::unique_ptr<State> state) : state_(std::move(state)) {}
SceneBridge::~SceneBridge() = default;

Result<std::unique_ptr<SceneBridge>> SceneBridge::create(Renderer& renderer,
                                                         const assets::Model& model) {
    auto state = std::make_unique<State>(renderer, model);
    if (auto added = state->addInstances(); !added) return tl::unexpected(added.error());
    std::unique_ptr<SceneBridge> bridge(new SceneBridge(std::move(state)));
    if (auto posed = bridge->pose(-1, 0); !posed) return tl::unexpected(posed.error());
    return bridge;
}

Result<void> SceneBridge::pose(int animation, float seconds) {
    State& s = *state_;
    RL_CHECK(animation < int(s.model.animations.size()), "the animation is one of the model");
    const auto poses =
        poseAt(s.model, animation >= 0 ? &s.model.animations[size_t(animation)] : nullptr, seconds);
    s.world = worldTransforms(s.model, poses);
    for (size_t i = 0; i < s.instances.size(); ++i) {
        const Source& source = s.sources[i];
        if (source.deformed)
            if (auto deformed = s.deformAgain(i, poses); !deformed) return deformed;
        // Joints take a vertex to world space; the node that holds the mesh has no say
        // (section 3.7.3.1).
        s.move(i, affine(source.skinned ? mat4(1) : s.world[size_t(source.node)]));
    }
    s.lights = lightsOf(s.model, s.nodes, s.world, s.notes);
    s.posed = true;
    return {};
}

void SceneBridge::fill(FrameInput& input) const {
    input.instances = state_->instances;
    input.previousTransforms = state_->previousTransforms;
    input.lighting.directional = state_->lights.directional;
    input.lighting.punctual = state_->lights.punctual;
}

bool SceneBridge::hasLights() const {
    return !state_->lights.directional.empty() || !state_->lights.punctual.empty();
}

Aabb SceneBridge::bounds() const {
    Aabb all;
    for (size_t i = 0; i < state_->instances.size(); ++i)
        if (!state_->sources[i].bounds.isEmpty())
            all.grow(transformAabb(state_->instances[i].worldFromLocal, state_->sources[i].bounds));
    return all;
}

std::optional<View> SceneBridge::cameraView(int camera) const {
    for (int node : state_->nodes)
        if (state_->model.nodes[size_t(node)].camera == camera)
            return viewOf(state_->model.cameras[size_t(camera)], state_->world[size_t(node)]);
    return {};
}

const std::vector<std::string>& SceneBridge::notes() const { return state_->notes; }

}  // namespace rushlight

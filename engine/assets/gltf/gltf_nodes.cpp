#include "engine/assets/gltf/gltf_builder.h"
#include "engine/assets/input_error.h"

#include <cmath>

namespace rushlight::assets {
namespace {

vec3 toVec3(const std::vector<double>& v) { return {float(v[0]), float(v[1]), float(v[2])}; }

void readTransform(Node& node, const tinygltf::Node& source) {
    if (source.matrix.size() == 16) {
        node.hasMatrix = true;
        for (int i = 0; i < 16; ++i) node.matrix[i / 4][i % 4] = float(source.matrix[size_t(i)]);
        return;
    }
    if (source.translation.size() == 3) node.translation = toVec3(source.translation);
    if (source.scale.size() == 3) node.scale = toVec3(source.scale);
    if (source.rotation.size() == 4) {
        const auto& r = source.rotation;
        node.rotation = glm::normalize(quat(float(r[3]), float(r[0]), float(r[1]), float(r[2])));
    }
}

LightType toLightType(const std::string& type) {
    if (type == "directional") return LightType::directional;
    return type == "spot" ? LightType::spot : LightType::point;
}

}  // namespace

void GltfBuilder::buildNodes() {
    if (gltf_.nodes.size() > options_.maxNodes)
        refuse("it has " + std::to_string(gltf_.nodes.size()) + " nodes; the limit is " +
               std::to_string(options_.maxNodes) + ".");
    model_.nodes.resize(gltf_.nodes.size());
    for (size_t i = 0; i < gltf_.nodes.size(); ++i) {
        const tinygltf::Node& source = gltf_.nodes[i];
        Node& node = model_.nodes[i];
        node.name = source.name;
        node.children = source.children;
        for (int child : source.children) model_.nodes[size_t(child)].parent = int(i);
        readTransform(node, source);
        buildReflectionProbe(i, source.extras);
        buildAreaLight(i, source.extras);
        node.mesh = source.mesh;
        node.skin = source.skin;
        node.camera = source.camera;
        node.weights.assign(source.weights.begin(), source.weights.end());
        const auto light = source.extensions.find("KHR_lights_punctual");
        if (light != source.extensions.end() && light->second.Has("light"))
            node.light = light->second.Get("light").GetNumberAsInt();
        if (!node.weights.empty() && node.mesh >= 0 &&
            !gltf_.meshes[size_t(node.mesh)].primitives.empty() &&
            node.weights.size() != gltf_.meshes[size_t(node.mesh)].primitives[0].targets.size())
            refuse(numbered("node", i, node.name) + ": it has " +
                   std::to_string(node.weights.size()) + " weights but its mesh has " +
                   std::to_string(gltf_.meshes[size_t(node.mesh)].primitives[0].targets.size()) +
                   " morph targets.");
    }
    for (size_t i = 0; i < gltf_.nodes.size(); ++i) buildNodeLight(int(i), gltf_.nodes[i]);
    for (size_t i = 0; i < gltf_.nodes.size(); ++i) {
        const auto instancing = gltf_.nodes[i].extensions.find("EXT_mesh_gpu_instancing");
        if (instancing != gltf_.nodes[i].extensions.end())
            buildInstances(int(i), instancing->second);
    }
}

/// EXT_mesh_gpu_instancing: the node's mesh moves to one child an instance.
void GltfBuilder::buildInstances(int index, const tinygltf::Value& extension) {
    const std::string what = numbered("node", size_t(index), model_.nodes[size_t(index)].name);
    if (model_.nodes[size_t(index)].mesh < 0 || !extension.Has("attributes")) return;
    const tinygltf::Value& attributes = extension.Get("attributes");
    int accessors[3] = {-1, -1, -1};
    const char* const names[3] = {"TRANSLATION", "ROTATION", "SCALE"};
    size_t count = 0;
    for (int a = 0; a < 3; ++a) {
        if (!attributes.Has(names[a])) continue;
        accessors[a] = attributes.Get(names[a]).GetNumberAsInt();
        if (componentCount(reader_.get(accessors[a])) != (a == 1 ? 4 : 3))
            refuse(what + ": the instance attribute " + names[a] + " has the wrong type.");
        if (count != 0 && count != reader_.count(accessors[a]))
            refuse(what + ": its instance attributes have different counts.");
        count = reader_.count(accessors[a]);
    }
    if (model_.nodes.size() + count > options_.maxNodes)
        refuse(what + ": with its " + std::to_string(count) + " instances the file has more than " +
               std::to_string(options_.maxNodes) + " nodes.");
    const auto translation = accessors[0] < 0 ? std::vector<vec3>()
                                              : reader_.vectors<vec3>(accessors[0]);
    const auto rotation = accessors[1] < 0 ? std::vector<vec4>()
                                           : reader_.vectors<vec4>(accessors[1]);
    const auto scale = accessors[2] < 0 ? std::vector<vec3>() : reader_.vectors<vec3>(accessors[2]);
    const Node parent = model_.nodes[size_t(index)];
    for (size_t i = 0; i < count; ++i) {
        Node node;
        node.name = parent.name;
        node.parent = index;
        node.mesh = parent.mesh;
        node.weights = parent.weights;
        if (!translation.empty()) node.translation = translation[i];
        if (!scale.empty()) node.scale = scale[i];
        if (!rotation.empty() && glm::length(rotation[i]) > 0) {
            const vec4 r = glm::normalize(rotation[i]);
            node.rotation = quat(r.w, r.x, r.y, r.z);
        }
        model_.nodes[size_t(index)].children.push_back(int(model_.nodes.size()));
        model_.nodes.push_back(std::move(node));
    }
    if (count != 0) model_.nodes[size_t(index)].mesh = -1;
    exact("EXT_mesh_gpu_instancing");
}

void GltfBuilder::buildScene() {
    const int scene = gltf_.defaultScene >= 0 ? gltf_.defaultScene : gltf_.scenes.empty() ? -1 : 0;
    if (scene >= 0) {
        model_.roots = gltf_.scenes[size_t(scene)].nodes;
        return;
    }
    for (size_t i = 0; i < model_.nodes.size(); ++i)
        if (model_.nodes[i].parent < 0) model_.roots.push_back(int(i));
}

void GltfBuilder::buildCameras() {
    for (const tinygltf::Camera& source : gltf_.cameras) {
        Camera camera;
        camera.name = source.name;
        camera.perspective = source.type == "perspective";
        if (camera.perspective) {
            camera.verticalFov = float(source.perspective.yfov);
            camera.aspect = float(source.perspective.aspectRatio);
            camera.nearPlane = float(source.perspective.znear);
            camera.farPlane = float(source.perspective.zfar);
        } else {
            camera.orthoHalfWidth = std::abs(float(source.orthographic.xmag));
            camera.orthoHalfHeight = std::abs(float(source.orthographic.ymag));
            camera.nearPlane = float(source.orthographic.znear);
            camera.farPlane = float(source.orthographic.zfar);
        }
        model_.cameras.push_back(std::move(camera));
    }
}

void GltfBuilder::buildLights() {
    for (const tinygltf::Light& source : gltf_.lights) {
        Light light;
        light.name = source.name;
        light.type = toLightType(source.type);
        if (source.color.size() == 3) light.color = toVec3(source.color);
        light.intensity = float(source.intensity);
        light.range = float(source.range);
        if (light.type == LightType::spot) {
            light.innerConeAngle = float(source.spot.innerConeAngle);
            light.outerConeAngle = float(source.spot.outerConeAngle);
        }
        readLightExtras(light, source.extras);
        model_.lights.push_back(std::move(light));
    }
    if (!model_.lights.empty()) exact("KHR_lights_punctual");
}

}  // namespace rushlight::assets

#include "renderer/scene_bridge/scene_lights.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

/// The way the node's -z points; straight down for a node that is scaled to nothing.
vec3 forwardOf(const mat4& world) {
    const vec3 z = -vec3(world[2]);
    const float length = glm::length(z);
    return length > 0 ? z / length : vec3(0, -1, 0);
}

void addPatterns(const assets::Light& from, const LightUploads& uploads, const mat4& world,
                 PunctualLight& light) {
    if (from.profile < 0 && from.cookie < 0) return;
    light.profile = uploads.profile(from.profile);
    light.cookie = uploads.cookie(from.cookie);
    light.direction = forwardOf(world);
    light.up = vec3(world[1]);
}

PunctualLight punctualOf(const assets::Light& from, const LightUploads& uploads,
                         const mat4& world) {
    PunctualLight light;
    light.position = vec3(world[3]);
    light.intensity = from.color * from.intensity;
    light.range = from.range;
    light.castsShadow = true;
    if (from.type == assets::LightType::spot) {
        light.direction = forwardOf(world);
        light.innerConeAngle = from.innerConeAngle;
        light.outerConeAngle = from.outerConeAngle;
    }
    addPatterns(from, uploads, world, light);
    return light;
}

AreaLight areaOf(const assets::AreaLight& from, const mat4& world) {
    AreaLight light;
    light.shape = AreaShape(from.shape);
    light.position = vec3(world[3]);
    light.halfX = vec3(world[0]) * from.size.x / 2.0f;
    light.halfY = vec3(world[1]) * from.size.y / -2.0f;  // the front is along -z
    if (from.shape == assets::AreaShape::tube) light.halfX = vec3(world[0]) * from.length / 2.0f;
    light.radius = from.radius;
    light.luminance = from.color * from.luminance;
    light.twoSided = from.twoSided;
    light.range = from.range;
    light.castsShadow = true;
    return light;
}

/// False where the node's transform leaves nothing of it, or turns a rectangle into another shape.
bool hasShape(const AreaLight& light) {
    const float x = glm::length(light.halfX), y = glm::length(light.halfY);
    if (light.shape == AreaShape::sphere) return true;
    if (light.shape == AreaShape::tube) return x > 0;
    constexpr float kSquare = 1e-3f;  // cosine between the sides
    return x > 0 && y > 0 && std::abs(glm::dot(light.halfX, light.halfY)) < kSquare * x * y;
}

template <class Light>
void limit(std::vector<Light>& lights, uint32_t most, const char* kind,
           std::vector<std::string>& notes) {
    if (lights.size() <= most) return;
    notes.push_back("Of " + std::to_string(lights.size()) + " " + kind + " lights the first " +
                    std::to_string(most) + " shine.");
    lights.resize(most);
}

}  // namespace

SceneLights lightsOf(const assets::Model& model, const LightUploads& uploads,
                     const std::vector<int>& nodes, const std::vector<mat4>& world,
                     std::vector<std::string>& notes) {
    SceneLights lights;
    for (int node : nodes) {
        const int index = model.nodes[size_t(node)].light;
        if (index < 0) continue;
        const assets::Light& from = model.lights[size_t(index)];
        const mat4& transform = world[size_t(node)];
        if (from.type != assets::LightType::directional) {
            lights.punctual.push_back(punctualOf(from, uploads, transform));
            continue;
        }
        DirectionalLight light;
        light.direction = forwardOf(transform);
        light.illuminance = from.color * from.intensity;
        lights.directional.push_back(light);
    }
    notes.clear();
    for (const assets::AreaLight& from : model.areaLights) {
        if (std::ranges::find(nodes, from.node) == nodes.end()) continue;
        lights.area.push_back(areaOf(from, world[size_t(from.node)]));
        if (hasShape(lights.area.back())) continue;
        lights.area.pop_back();
        notes.push_back("The area light of node " + std::to_string(from.node) +
                        " is left out: its node's transform flattens or shears it.");
    }
    limit(lights.area, kMaxAreaLights, "area", notes);
    limit(lights.directional, kMaxDirectionalLights, "directional", notes);
    limit(lights.punctual, kMaxPunctualLights, "point and spot", notes);
    return lights;
}

// The file's own aspect ratio is not looked at: content is never stretched, and the vertical field
// is kept (glTF 2.0, 3.10.2). So with the width of an orthographic camera.
View viewOf(const assets::Camera& camera, const mat4& worldFromNode) {
    const vec3 back = -forwardOf(worldFromNode);
    const vec3 right = glm::normalize(glm::cross(vec3(worldFromNode[1]), back));
    const mat4 worldFromView(vec4(right, 0), vec4(glm::cross(back, right), 0), vec4(back, 0),
                             worldFromNode[3]);
    View view;
    view.viewFromWorld = glm::inverse(worldFromView);
    view.perspective = camera.perspective;
    view.verticalFov = camera.verticalFov;
    view.orthoHalfHeight = camera.orthoHalfHeight;
    view.nearPlane = camera.nearPlane;
    view.farPlane = camera.farPlane;
    return view;
}

}  // namespace rushlight

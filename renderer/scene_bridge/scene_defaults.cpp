#include "renderer/scene_bridge/scene_defaults.h"

#include <algorithm>
#include <cmath>

namespace rushlight {

View viewThatFrames(const Aabb& bounds, float verticalFov, float aspect) {
    const vec3 center = bounds.isEmpty() ? vec3(0) : bounds.center();
    const float radius = bounds.isEmpty() ? 1.0f
                                          : std::max(glm::length(bounds.halfExtent()), 1e-4f);
    const float halfVertical = verticalFov / 2;
    const float half = std::min(halfVertical, std::atan(std::tan(halfVertical) * aspect));
    const float distance = radius / std::sin(half);
    View view;
    view.verticalFov = verticalFov;
    view.viewFromWorld = glm::lookAt(center + distance * glm::normalize(vec3(0.35f, 0.3f, 1)),
                                     center, vec3(0, 1, 0));
    view.nearPlane = std::max(distance - 2 * radius, distance * 0.01f);
    return view;
}

DefaultLights defaultLights(const View& view) {
    const mat4 worldFromView = glm::inverse(view.viewFromWorld);
    DefaultLights lights;
    lights.sun.direction = glm::normalize(mat3(worldFromView) * vec3(-0.3f, -0.6f, -1));
    lights.sun.illuminance = vec3(3);
    return lights;
}

}  // namespace rushlight

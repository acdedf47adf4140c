#include "renderer/answers/frame_survey.h"

#include "renderer/geometry/view_math.h"

#include <algorithm>
#include <limits>

namespace rushlight {
namespace {

bool isOutside(const Plane& plane, const Aabb& box) {
    const float radius = glm::dot(glm::abs(plane.normal), box.halfExtent());
    return glm::dot(plane.normal, box.center()) + plane.offset < -radius;
}

void sort(const CameraMatrices& camera, const Aabb& box, FrameSurvey& found) {
    const float along = glm::dot(box.center() - camera.position, camera.forward);
    const float radius = glm::dot(glm::abs(camera.forward), box.halfExtent());
    found.nearest = std::min(found.nearest, along - radius);
    found.farthest = std::max(found.farthest, along + radius);
    const auto& planes = camera.frustum.planes;  // left, right, bottom, top, near, far
    const bool aside = std::any_of(planes.begin(), planes.begin() + 4,
                                   [&](const Plane& plane) { return isOutside(plane, box); });
    if (along + radius < 0 && camera.perspective)
        ++found.behind;
    else if (isOutside(planes[5], box) && !aside)
        ++found.beyondFar;
    else if (isOutside(planes[4], box) && !aside)
        ++found.beforeNear;
    else if (aside)
        ++found.aside;
    else
        ++found.inView;
}

}  // namespace

FrameSurvey survey(const View& view, float aspect, std::span<const InstanceFacts> instances) {
    FrameSurvey found;
    const auto camera = makeCamera(view, aspect);
    if (!camera) return found;
    found.nearest = std::numeric_limits<float>::max();
    found.farthest = -found.nearest;
    for (const InstanceFacts& facts : instances) {
        if (facts.rejected) continue;
        ++found.instances;
        sort(*camera, facts.bounds, found);
    }
    return found;
}

uint32_t inViewOf(View view, const mat4& viewFromWorld, float aspect,
                  std::span<const InstanceFacts> instances) {
    view.viewFromWorld = viewFromWorld;
    return survey(view, aspect, instances).inView;
}

}  // namespace rushlight

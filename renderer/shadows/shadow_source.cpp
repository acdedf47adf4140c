#include "renderer/shadows/shadow_source.h"

#include "engine/core/hash.h"
#include "renderer/lighting/clusters/light_clusters.h"
#include "renderer/shadows/shadow_view.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

/// A spot with a wider cone has a cube's faces: a single view would waste its texels at the rim.
constexpr float kWidestSpot = 1.05f;
/// Penumbrae of area lights are wide: a filter may reach half as far beyond a view's edge as from
/// its middle to there.
constexpr uint32_t kAreaBorder = 6;

template <class Light>
float rangeOf(const Light& light) {
    if (light.range > 0) return light.range;
    const float range = effectiveRange(light);
    return range > 0 ? std::exp2(std::ceil(std::log2(range))) : 0;
}

float peakOf(const vec3& v) { return std::max({v.x, v.y, v.z, 0.0f}); }

uint64_t identityOf(const ShadowSource& s) {
    const vec3 z = s.faceCount == 6 ? vec3(0) : s.axes[2];
    const float parts[] = {s.position.x,
                           s.position.y,
                           s.position.z,
                           s.range,
                           s.nearPlanes.z,
                           z.x,
                           z.y,
                           z.z,
                           s.isCube() ? 0.0f : s.tanHalf};
    return hashBytes(parts, sizeof parts, 11) | 1;
}

uint64_t areaIdentityOf(const ShadowSource& s) {
    const vec3 parts[] = {
        s.position, s.axes[0], s.axes[2], s.nearPlanes, {s.range, float(s.faceCount), 0}};
    return hashBytes(parts, sizeof parts, 12) | 1;
}

mat3 axesAround(const vec3& z) {
    vec3 x, y;
    spotBasis(z, x, y);
    return {glm::cross(y, z), y, z};
}

}  // namespace

void ShadowSource::face(uint32_t index, vec3& right, vec3& up, vec3& forward) const {
    if (!isCube()) {
        forward = axes[2];
        spotBasis(forward, right, up);
        return;
    }
    cubeFaceBasis(index, right, up, forward);
    for (vec3* v : {&right, &up, &forward}) *v = axes * *v;
}

ShadowSource makeShadowSource(const PunctualLight& light) {
    ShadowSource s;
    s.position = light.position;
    s.range = rangeOf(light);
    s.nearPlanes = vec3(std::max(light.shadowNear, 1e-3f));
    s.radius = light.radius;
    s.peak = peakOf(light.intensity);
    const bool cube = light.outerConeAngle < 0 || light.outerConeAngle > kWidestSpot;
    s.faceCount = cube ? 6 : 1;
    if (!cube) {
        const float length = glm::length(light.direction);
        s.axes[2] = length > 0 ? light.direction / length : vec3(0, -1, 0);
        s.tanHalf = std::tan(std::max(light.outerConeAngle, 0.02f));
    }
    s.identity = identityOf(s);
    return s;
}

ShadowSource makeShadowSource(const AreaLight& light) {
    ShadowSource s;
    s.position = light.position;
    s.range = rangeOf(light);
    s.border = kAreaBorder;
    s.faceCount = 6;
    const float gap = std::max(light.shadowNear, 1e-3f);
    const float x = glm::length(light.halfX), y = glm::length(light.halfY);
    switch (light.shape) {
        case AreaShape::rectangle:
        case AreaShape::disk:
            s.axes[0] = light.halfX / x;
            s.axes[2] = glm::normalize(glm::cross(light.halfX, light.halfY));
            s.axes[1] = glm::cross(s.axes[2], s.axes[0]);
            s.nearPlanes = vec3(gap);
            s.radius = std::sqrt(x * y);
            s.faceCount = light.twoSided ? 6 : 5;
            break;
        case AreaShape::sphere:
            s.nearPlanes = vec3(light.radius + gap);
            s.radius = light.radius;
            break;
        case AreaShape::tube:
            s.axes = axesAround(light.halfX / x);
            s.nearPlanes = vec3(light.radius + gap, light.radius + gap, x + gap);
            s.radius = light.radius;
            break;
    }
    s.peak = peakOf(light.luminance) * shownArea(light);
    s.identity = areaIdentityOf(s);
    return s;
}

}  // namespace rushlight

#include "renderer/raytrace/area_sampling.h"

#include "interop/brdf.h"
#include "renderer/geometry/vertex_packing.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

/// Of a light's surface, from its middle.
struct SurfacePoint {
    vec3 place{0};
    vec3 normal{0};
    float area = 0;  ///< square metres over the density within it; 0: there is no point
};

SurfacePoint flatPoint(const AreaLight& light, float u, float v) {
    const vec3 across = glm::cross(light.halfX, light.halfY);
    const float quarter = glm::length(across);
    if (!(quarter > 0)) return {};
    if (light.shape == AreaShape::rectangle)
        return {light.halfX * (2 * u - 1) + light.halfY * (2 * v - 1), across / quarter,
                4 * quarter};
    const float r = std::sqrt(u), phi = 2 * kPi * v;
    return {light.halfX * (r * std::cos(phi)) + light.halfY * (r * std::sin(phi)), across / quarter,
            kPi * quarter};
}

// Of the side, what lies between the two tangents from `from` (relative to the middle), and the end
// that looks there.
SurfacePoint tubePoint(const AreaLight& light, const vec3& from, float u, float v) {
    const float half = glm::length(light.halfX), radius = light.radius;
    if (!(half > 0 && radius > 0)) return {};
    const vec3 axis = light.halfX / half;
    const float axial = glm::dot(from, axis);
    const vec3 beside = from - axis * axial;
    const float away = glm::length(beside);
    const vec3 x = away > 1e-6f * radius ? beside / away : perpendicular(axis);
    const vec3 y = glm::cross(axis, x);
    const float beta = away > radius ? std::acos(radius / away) : 0;
    const float side = 4 * beta * radius * half;
    const float end = std::abs(axial) > half ? kPi * radius * radius : 0;
    const float place = u * (side + end);
    if (place < side) {
        const float angle = beta * (2 * v - 1);
        const vec3 out = x * std::cos(angle) + y * std::sin(angle);
        return {axis * (half * (2 * place / side - 1)) + out * radius, out, side + end};
    }
    if (!(end > 0)) return {};
    const float r = radius * std::sqrt((place - side) / end), phi = 2 * kPi * v;
    const vec3 outwards = axis * (axial < 0 ? -1.0f : 1.0f);
    return {outwards * half + x * (r * std::cos(phi)) + y * (r * std::sin(phi)), outwards,
            side + end};
}

// Things are nearer to a surface than along a ray that leaves it aslant.
float withoutNear(const AreaLight& light, float distance, float cosine) {
    return distance * 0.9999f - light.shadowNear / std::max(cosine, 1e-4f);
}

AreaSample sampleSphere(const AreaLight& light, const vec3& center, float u, float v) {
    const float distance2 = glm::dot(center, center), radius2 = light.radius * light.radius;
    if (!(light.radius > 0 && distance2 > radius2)) return {};
    const float distance = std::sqrt(distance2);
    // What the cone's cosine lacks of 1, exact for small ones.
    const float share = radius2 / distance2;
    const float wide = share / (1 + std::sqrt(1 - share));
    const float lacks = u * wide, phi = 2 * kPi * v;
    const float sine2 = lacks * (2 - lacks), sine = std::sqrt(sine2);
    const vec3 towards = center / distance, x = perpendicular(towards);
    const vec3 y = glm::cross(towards, x);
    const float cosine = std::sqrt(std::max(0.0f, 1 - sine2 / share));  // at the sphere
    AreaSample s;
    s.direction = glm::normalize(towards * (1 - lacks) + x * (sine * std::cos(phi)) +
                                 y * (sine * std::sin(phi)));
    s.distance = withoutNear(light, distance * (1 - lacks) - light.radius * cosine, cosine);
    s.light = light.luminance * (2 * kPi * wide);
    return s;
}

AreaSample sampleSurface(const AreaLight& light, const vec3& center, float u, float v) {
    const bool flat = light.shape != AreaShape::tube;
    const SurfacePoint point = flat ? flatPoint(light, u, v) : tubePoint(light, -center, u, v);
    const vec3 to = center + point.place;
    const float distance2 = glm::dot(to, to);
    if (!(point.area > 0 && distance2 > 0)) return {};
    const float distance = std::sqrt(distance2);
    AreaSample s;
    s.direction = to / distance;
    float cosine = -glm::dot(s.direction, point.normal);
    if (flat && light.twoSided) cosine = std::abs(cosine);
    if (!(cosine > 0)) return {};
    s.distance = withoutNear(light, distance, cosine);
    s.light = light.luminance * (point.area * cosine / distance2);
    return s;
}

}  // namespace

AreaSample sampleAreaLight(const AreaLight& light, const vec3& position, RayRandom& random) {
    const float u = random.next(), v = random.next();
    const vec3 center = light.position - position;
    // The window of shaders/common/light/area_lights.glsl.
    const float x = glm::dot(center, center) * interop::inverseRangeSquared(light.range);
    const float reach = 1 - x * x;
    if (!(reach > 0)) return {};
    AreaSample s = light.shape == AreaShape::sphere ? sampleSphere(light, center, u, v)
                                                    : sampleSurface(light, center, u, v);
    s.light *= reach;
    return s;
}

bool standsFor(const AreaLight& light, const vec3& position, const vec3& direction) {
    const vec3 from = position - light.position;
    const float near = light.shadowNear;
    if (light.shape == AreaShape::sphere) return glm::length(from) <= light.radius + near;
    const float x = glm::length(light.halfX);
    if (!(x > 0)) return false;
    const float alongX = glm::dot(from, light.halfX) / x;
    if (light.shape == AreaShape::tube)
        return std::abs(alongX) <= x + near &&
               glm::length(from - light.halfX * (alongX / x)) <= light.radius + near;
    const vec3 across = glm::cross(light.halfX, light.halfY);
    const float y = glm::length(light.halfY), quarter = glm::length(across);
    if (!(quarter > 0) || (!light.twoSided && glm::dot(across, direction) >= 0)) return false;
    if (std::abs(glm::dot(from, across)) > near * quarter) return false;
    const float a = alongX / (x + near), b = glm::dot(from, light.halfY) / (y * (y + near));
    return light.shape == AreaShape::disk ? a * a + b * b <= 1
                                          : std::max(std::abs(a), std::abs(b)) <= 1;
}

}  // namespace rushlight

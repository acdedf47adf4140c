#include "renderer/visibility/shadow_cascades.h"

#include "shaders/interop/frame_uniforms.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

struct Sphere {
    vec3 center;
    float radius;
};

// Around the corners of the view volume between two depths; centred on the view axis, so that
// turning the camera does not change its radius.
Sphere sphereAround(const CameraMatrices& camera, float nearDepth, float farDepth) {
    if (!camera.perspective) {
        const float half = (farDepth - nearDepth) / 2;
        const float radius = std::sqrt(camera.halfWidth * camera.halfWidth +
                                       camera.halfHeight * camera.halfHeight + half * half);
        return {camera.position + camera.forward * (nearDepth + half), radius};
    }
    // To the farthest corner; without the jitter, which would change the sphere at every frame.
    const vec2 reach = glm::abs(camera.center - camera.jittered) +
                       vec2(camera.tanHalfX, camera.tanHalfY);
    const float k2 = glm::dot(reach, reach);
    const float depth = std::min((1 + k2) * (nearDepth + farDepth) / 2, farDepth);
    const float dn = depth - nearDepth, df = farDepth - depth;
    const float radius = std::sqrt(
        std::max(dn * dn + k2 * nearDepth * nearDepth, df * df + k2 * farDepth * farDepth));
    return {camera.position + camera.forward * depth, radius};
}

// How far the scene reaches along the view axis.
float farthestDepth(const CameraMatrices& camera, const Aabb& bounds) {
    const vec3 center = bounds.center() - camera.position;
    return glm::dot(center, camera.forward) +
           glm::dot(glm::abs(camera.forward), bounds.halfExtent());
}

// A step of 2^(1/8): the size of a cascade that follows the scene's bounds changes rarely, and so
// does its texel grid.
float roundUpRadius(float radius) { return std::exp2(std::ceil(std::log2(radius) * 8) / 8); }

// Around a receiver the filter and the normal offset reach this far.
float reachTexels(const ShadowCascades& cascades) { return 2 * cascades.rim; }

}  // namespace

// A filter compares its texels with the receiver's plane, which may lie far behind the receiver
// there: so may what casts.
void ShadowCascades::addVolume(uint32_t index, const Frustum& camera, CullVolume& volume) const {
    const ShadowCascade& cascade = cascades[index];
    volume.add(cascade.frustum);
    if (cascade.followsCamera)
        addSwept(volume, camera, glm::normalize(vec3(rows[2])),
                 reachTexels(*this) * cascade.metresPerTexel,
                 rim * RL_STEEPEST_RECEIVER * cascade.metresPerTexel);
}

bool ShadowCascades::isFinerElsewhere(uint32_t index, const vec3& center,
                                      const vec3& halfExtent) const {
    const ShadowCascade& cascade = cascades[index];
    const vec3 x(rows[0]), y(rows[1]);
    const vec2 middle(glm::dot(x, center), glm::dot(y, center));
    const vec2 reach = vec2(glm::dot(glm::abs(x), halfExtent), glm::dot(glm::abs(y), halfExtent)) +
                       reachTexels(*this) * cascade.metresPerTexel;
    for (uint32_t i = 0; i < index; ++i) {
        const ShadowCascade& finer = cascades[i];
        const vec2 low = (middle - reach) * finer.uvPerMetre + finer.uvOffset;
        const vec2 high = (middle + reach) * finer.uvPerMetre + finer.uvOffset;
        // Where sunVisibility (shaders/common/shadow/sun_shadow.glsl) looks into the finer cascade
        // alone.
        const float inner = rim / float(resolution) + float(RL_CASCADE_BAND);
        if (low.x > inner && low.y > inner && high.x < 1 - inner && high.y < 1 - inner) return true;
    }
    return false;
}

ShadowCascades makeShadowCascades(const CameraMatrices& camera, const ShadowCascadeDesc& desc) {
    ShadowCascades result;
    result.count = std::clamp(desc.count, 1u, 4u);
    result.resolution = desc.resolution;
    result.rim = float(desc.rim);

    const vec3 towardsLight = -glm::normalize(desc.lightDirection);
    const vec3 helper = std::abs(towardsLight.y) < 0.99f ? vec3(0, 1, 0) : vec3(0, 0, 1);
    const vec3 x = glm::normalize(glm::cross(helper, towardsLight));
    const vec3 y = glm::cross(towardsLight, x);

    // Depth along the light covers the whole scene, for every cascade alike.
    const float middle = glm::dot(desc.sceneBounds.center(), towardsLight);
    const float reach = glm::dot(glm::abs(towardsLight), desc.sceneBounds.halfExtent()) * 1.01f +
                        0.01f;
    const float scaleZ = 1 / (2 * reach);
    result.rows[0] = vec4(x, 0);
    result.rows[1] = vec4(y, 0);
    result.rows[2] = vec4(towardsLight * scaleZ, 0.5f - middle * scaleZ);

    float limit = std::max(farthestDepth(camera, desc.sceneBounds), camera.nearPlane * 2);
    if (camera.farPlane > 0) limit = std::min(limit, camera.farPlane);
    if (desc.distance > 0) limit = std::min(limit, desc.distance);

    // No need to cover more than the scene itself.
    const float sceneRadius = glm::length(desc.sceneBounds.halfExtent());
    const float nearest = camera.nearPlane;
    for (uint32_t i = 0; i < result.count; ++i) {
        // Zhang et al., "Parallel-Split Shadow Maps", 2006: between logarithmic and even splits.
        const float t = float(i + 1) / float(result.count);
        const float start = std::max(nearest, limit * 0.01f);
        const float logarithmic = start * std::pow(limit / start, t);
        const float even = start + (limit - start) * t;
        const float farDepth = i + 1 == result.count ? limit : 0.7f * logarithmic + 0.3f * even;

        Sphere sphere = sphereAround(camera, nearest, farDepth);
        ShadowCascade& cascade = result.cascades[i];
        cascade.followsCamera = sphere.radius <= sceneRadius;
        if (!cascade.followsCamera) sphere = {desc.sceneBounds.center(), sceneRadius};
        const float radius = roundUpRadius(sphere.radius);

        // One texel of margin on each side, as the centre is rounded to texels.
        cascade.metresPerTexel = 2 * radius / float(desc.resolution - 2);
        const float side = cascade.metresPerTexel * float(desc.resolution);
        cascade.uvPerMetre = 1 / side;
        const auto snap = [&](float v) {
            return std::floor(v / cascade.metresPerTexel) * cascade.metresPerTexel;
        };
        const vec2 center(snap(glm::dot(sphere.center, x)), snap(glm::dot(sphere.center, y)));
        cascade.uvOffset = vec2(0.5f) - center * cascade.uvPerMetre;

        mat4 clip(0.0f);
        for (int c = 0; c < 3; ++c) {
            clip[c][0] = 2 * cascade.uvPerMetre * x[c];
            clip[c][1] = 2 * cascade.uvPerMetre * y[c];
            clip[c][2] = result.rows[2][c];
        }
        clip[3] = vec4(2.0f * cascade.uvOffset - 1.0f, result.rows[2].w, 1);
        cascade.clipFromWorld = clip;
        cascade.frustum = frustumOf(clip);
        cascade.frustum.planes[4] = {vec3(0), 0};  // towards the light: depth is clamped instead
    }
    return result;
}

}  // namespace rushlight

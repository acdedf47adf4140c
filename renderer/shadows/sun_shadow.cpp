#include "renderer/shadows/sun_shadow.h"

#include <cmath>

namespace rushlight {

interop::ViewUniforms makeViewUniforms(const ShadowCascade& cascade) {
    interop::ViewUniforms u{};
    u.clipFromWorld = u.previousClipFromWorld = cascade.clipFromWorld;
    return u;
}

interop::ViewUniforms makeViewUniforms(const ShadowView& view) {
    interop::ViewUniforms u{};
    u.clipFromWorld = u.previousClipFromWorld = view.clipFromWorld;
    return u;
}

SunShadow makeSunShadow(const CameraMatrices& camera, const ShadowCascades& cascades,
                        float angularRadius) {
    SunShadow u;
    // Rows from camera-relative positions: the camera's own place goes into the constant.
    for (int i = 0; i < 3; ++i) {
        const vec4 row = cascades.rows[i];
        u.rows[i] = vec4(vec3(row), row.w + glm::dot(vec3(row), camera.position));
    }
    for (uint32_t i = 0; i < cascades.count; ++i) {
        const ShadowCascade& c = cascades.cascades[i];
        u.cascades[i] = {c.uvPerMetre, c.uvOffset.x, c.uvOffset.y, c.metresPerTexel};
    }
    const float resolution = float(cascades.resolution);
    const bool fades = cascades.cascades[cascades.count - 1].followsCamera;
    const float depthPerMetre = glm::length(vec3(cascades.rows[2]));
    u.settings = {depthPerMetre, resolution, 1 / resolution,
                  fades ? 1 / float(RL_CASCADE_BAND) : 1e6f};
    u.softness = {std::tan(angularRadius) / depthPerMetre, 0, 0, 0};
    return u;
}

}  // namespace rushlight

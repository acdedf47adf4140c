#include "renderer/geometry/view_math.h"

#include <cmath>

namespace rushlight {
mat4 reversedPerspective(float tanHalfX, float tanHalfY, float nearPlane, float farPlane) {
    mat4 m(0.0f);
    m[0][0] = 1 / tanHalfX;
    m[1][1] = 1 / tanHalfY;
    m[2][3] = -1;
    if (farPlane > 0) {
        m[2][2] = nearPlane / (farPlane - nearPlane);
        m[3][2] = nearPlane * farPlane / (farPlane - nearPlane);
    } else {
        m[3][2] = nearPlane;
    }
    return m;
}

mat4 reversedOrthographic(float halfWidth, float halfHeight, float nearPlane, float farPlane) {
    mat4 m(1.0f);
    m[0][0] = 1 / halfWidth;
    m[1][1] = 1 / halfHeight;
    m[2][2] = 1 / (farPlane - nearPlane);
    m[3][2] = farPlane / (farPlane - nearPlane);
    return m;
}

Frustum frustumOf(const mat4& clip) {
    const mat4 rows = glm::transpose(clip);
    const vec4 candidates[6] = {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
                                rows[3] - rows[1], rows[3] - rows[2], rows[2]};
    Frustum frustum;
    for (size_t i = 0; i < 6; ++i) {
        const vec3 normal(candidates[i]);
        const float length = glm::length(normal);
        frustum.planes[i] = length > 1e-12f ? Plane{normal / length, candidates[i].w / length}
                                            : Plane{vec3(0), 0};  // an infinite far plane
    }
    return frustum;
}

bool intersects(const Frustum& frustum, const vec3& center, const vec3& halfExtent) {
    for (const Plane& plane : frustum.planes) {
        const float radius = glm::dot(glm::abs(plane.normal), halfExtent);
        if (glm::dot(plane.normal, center) + plane.offset < -radius) return false;
    }
    return true;
}

bool intersects(const Frustum& frustum, const vec3& center, float radius) {
    for (const Plane& plane : frustum.planes)
        if (glm::dot(plane.normal, center) + plane.offset < -radius) return false;
    return true;
}

Result<CameraMatrices> makeCamera(const View& view, float targetAspect) {
    const auto wrong = [](const std::string& what) {
        return fail("view", what, ErrorKind::wrongUse);
    };
    if (!isFinite(view.viewFromWorld) || std::abs(glm::determinant(view.viewFromWorld)) < 1e-12f)
        return wrong("viewFromWorld is not finite or cannot be inverted.");
    if (!std::isfinite(view.nearPlane) || !std::isfinite(view.farPlane) ||
        !std::isfinite(view.aspect))
        return wrong("the near plane is " + std::to_string(view.nearPlane) + " m, the far plane " +
                     std::to_string(view.farPlane) + " m and the aspect " +
                     std::to_string(view.aspect) +
                     "; all must be finite (a far plane of 0 stands for infinity).");
    if (!(view.nearPlane > 0) && view.perspective)
        return wrong("the near plane is " + std::to_string(view.nearPlane) +
                     " m; a perspective view needs more than 0.");
    if (view.perspective && !(view.verticalFov > 0 && view.verticalFov < 3.1f))
        return wrong("the vertical field of view is " + std::to_string(view.verticalFov) +
                     " rad; it must be above 0 and below 3.1.");
    if (!view.perspective && !(view.orthoHalfHeight > 0 && std::isfinite(view.orthoHalfHeight) &&
                               view.farPlane > view.nearPlane))
        return wrong("an orthographic view needs a positive height and far > near.");
    if (view.farPlane != 0 && !(view.farPlane > view.nearPlane))
        return wrong("the far plane is not beyond the near plane.");

    if (!std::isfinite(glm::dot(view.frustum, view.frustum)) ||
        (view.frustum != vec4(0) &&
         !(view.frustum.x < view.frustum.y && view.frustum.z < view.frustum.w)))
        return wrong(
            "its frustum is not finite, or its left edge is not left of its right one, or "
            "its bottom not below its top.");
    if (!(glm::all(glm::lessThanEqual(glm::abs(view.jitter), vec2(1)))))
        return wrong("the jitter is " + std::to_string(view.jitter.x) + ", " +
                     std::to_string(view.jitter.y) + " pixels; it must be -1 to 1.");

    CameraMatrices camera;
    const float aspect = view.aspect > 0 ? view.aspect : targetAspect;
    camera.perspective = view.perspective;
    camera.nearPlane = view.nearPlane;
    camera.farPlane = view.farPlane;
    camera.viewFromWorld = view.viewFromWorld;
    if (view.perspective) {
        camera.tanHalfY = std::tan(view.verticalFov / 2);
        camera.tanHalfX = camera.tanHalfY * aspect;
        if (const vec4& edges = view.frustum; edges != vec4(0)) {
            camera.tanHalfX = (edges.y - edges.x) / 2;
            camera.tanHalfY = (edges.w - edges.z) / 2;
            camera.center = {(edges.x + edges.y) / 2, (edges.z + edges.w) / 2};
        }
        camera.clipFromView = reversedPerspective(camera.tanHalfX, camera.tanHalfY, view.nearPlane,
                                                  view.farPlane);
        camera.clipFromView[2][0] = camera.center.x / camera.tanHalfX;
        camera.clipFromView[2][1] = camera.center.y / camera.tanHalfY;
        // z = m22 * -d + m32, w = d  =>  d = m32 / (depth + m22)
        const float m22 = camera.clipFromView[2][2], m32 = camera.clipFromView[3][2];
        camera.depthDecode = {1 / m32, m22 / m32};
    } else {
        camera.halfHeight = view.orthoHalfHeight;
        camera.halfWidth = view.orthoHalfHeight * aspect;
        camera.clipFromView = reversedOrthographic(camera.halfWidth, camera.halfHeight,
                                                   view.nearPlane, view.farPlane);
        const float range = view.farPlane - view.nearPlane;
        camera.depthDecode = {-range, view.farPlane};
    }
    camera.clipFromWorld = camera.clipFromView * view.viewFromWorld;
    camera.previousClipFromWorld = camera.clipFromWorld;
    const mat4 worldFromView = glm::inverse(view.viewFromWorld);
    camera.position = vec3(worldFromView[3]);
    camera.right = glm::normalize(vec3(worldFromView[0]));
    camera.up = glm::normalize(vec3(worldFromView[1]));
    camera.forward = -glm::normalize(vec3(worldFromView[2]));
    camera.frustum = frustumOf(camera.clipFromWorld);
    return camera;
}

// A move in clip space by a share of w, which is 1 in orthographic views.
void jitterCamera(CameraMatrices& camera, const vec2& pixels, uint32_t width, uint32_t height) {
    const vec2 ndc = 2.0f * pixels / vec2(float(width), float(height));
    if (ndc == vec2(0)) return;
    mat4 move(1);
    move[3] = vec4(-ndc, 0, 1);
    camera.clipFromView = move * camera.clipFromView;
    camera.clipFromWorld = move * camera.clipFromWorld;
    camera.previousClipFromWorld = move * camera.previousClipFromWorld;
    camera.jittered = ndc * (camera.perspective ? vec2(camera.tanHalfX, camera.tanHalfY)
                                                : vec2(camera.halfWidth, camera.halfHeight));
    camera.center += camera.jittered;
}

vec3 CameraMatrices::relativePosition(vec2 uv, float viewDepth) const {
    const vec2 ndc = uv * 2.0f - 1.0f;
    const vec2 half = perspective ? vec2(tanHalfX, tanHalfY) : vec2(halfWidth, halfHeight);
    const vec2 place = center + ndc * half;
    if (perspective) return (forward + right * place.x + up * place.y) * viewDepth;
    return right * place.x + up * place.y + forward * viewDepth;
}

}  // namespace rushlight

#pragma once
// Cameras as matrices. Clip space: z in [0, w], reversed (near plane at 1, far at 0).

#include "engine/core/bounds.h"
#include "engine/core/result.h"
#include "renderer/frame/frame_input.h"

#include <array>

namespace rushlight {

struct Plane {
    vec3 normal;   ///< unit, inwards
    float offset;  ///< dot(normal, p) + offset >= 0 inside
};

/// Left, right, bottom, top, near, far; an infinite far plane accepts everything.
struct Frustum {
    std::array<Plane, 6> planes;
};

/// What the passes need to know of a camera, worked out once a frame.
struct CameraMatrices {
    mat4 viewFromWorld;
    mat4 clipFromView;
    mat4 clipFromWorld;
    mat4 previousClipFromWorld;  ///< of the view's last frame; makeCamera: as now
    vec3 position;
    vec3 right, up, forward;              ///< world, unit
    float tanHalfX = 1, tanHalfY = 1;     ///< perspective: of half the view angles
    float halfWidth = 1, halfHeight = 1;  ///< orthographic
    vec2 center{0};    ///< where the picture's middle lies off the view axis: tangents, or metres
    vec2 jittered{0};  ///< the part of it that comes of jitter
    float nearPlane = 0.1f;
    float farPlane = 0;  ///< 0: infinite
    bool perspective = true;
    vec2 depthDecode;  ///< see LightingUniforms
    Frustum frustum;

    /// Where a pixel at uv in [0,1]² with this view depth is, relative to the camera, in world
    /// axes.
    vec3 relativePosition(vec2 uv, float viewDepth) const;
};

/// Moves the picture by a part of a pixel of one so large: what is rasterised, and what is looked
/// up in it. The frustum, for culling, stays; previousClipFromWorld moves likewise, so that what
/// stands still has no velocity.
void jitterCamera(CameraMatrices& camera, const vec2& pixels, uint32_t width, uint32_t height);

/// An Error when the view is not finite, not invertible or its ranges are empty.
Result<CameraMatrices> makeCamera(const View& view, float targetAspect);

mat4 reversedPerspective(float tanHalfX, float tanHalfY, float nearPlane, float farPlane);
mat4 reversedOrthographic(float halfWidth, float halfHeight, float nearPlane, float farPlane);

/// Planes of a clip matrix with reversed z. Gribb and Hartmann, 2001.
Frustum frustumOf(const mat4& clipFromWorld);

/// Conservative: may accept a box near an edge of the frustum that is outside.
bool intersects(const Frustum&, const vec3& boxCenter, const vec3& boxHalfExtent);
/// Of a ball.
bool intersects(const Frustum&, const vec3& center, float radius);

}  // namespace rushlight

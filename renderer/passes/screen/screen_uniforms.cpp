#include "renderer/passes/screen/screen_uniforms.h"

namespace rushlight {
namespace {

// Depths that differ by more than this share of the distance, or of the height of an orthographic
// view, are not one surface where a filter expected them to be.
constexpr float kSurfaceTolerance = 0.015f;

}  // namespace

interop::ScreenUniforms makeScreenUniforms(const CameraMatrices& camera, uint32_t width,
                                           uint32_t height) {
    const vec2 size{float(width), float(height)};
    const vec2 half = camera.perspective ? vec2(camera.tanHalfX, camera.tanHalfY)
                                         : vec2(camera.halfWidth, camera.halfHeight);
    interop::ScreenUniforms u{};
    u.viewFromTexel = vec4(2.0f * half / size, camera.center - half);
    // Perspective: 1 / viewDepth = x * d + y, so that a share of it is one of d + y / x.
    const vec2 decode = camera.depthDecode;
    const vec2 tolerance = camera.perspective ? kSurfaceTolerance * vec2(1, decode.y / decode.x)
                                              : vec2(0, kSurfaceTolerance * 2 * camera.halfHeight /
                                                            std::abs(decode.x));
    u.depthDecode = vec4(decode, tolerance);
    u.size = vec4(size, size / (2.0f * half));
    u.right = vec4(camera.right, float(halfSize(width)));
    u.up = vec4(camera.up, float(halfSize(height)));
    u.back = vec4(-camera.forward, 0);
    return u;
}

}  // namespace rushlight

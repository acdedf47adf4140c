#include "renderer/frame/contact_shadows.h"

namespace rushlight {

// A point at x to the right, y up and z ahead is shown at pixel
//     ((1/2 + x / (2 tanX z)) width, (1/2 + y / (2 tanY z)) height);
// times z that is linear along a ray, and so its change per metre is that of the direction.
void fillContactShadows(const CameraMatrices& camera, uint32_t width, uint32_t height,
                        const vec3& towardsLight, float length, interop::LightingUniforms& u) {
    const float x = glm::dot(towardsLight, camera.right), y = glm::dot(towardsLight, camera.up);
    const float z = glm::dot(towardsLight, camera.forward);
    const vec2 half = camera.perspective ? vec2(camera.tanHalfX, camera.tanHalfY)
                                         : vec2(camera.halfWidth, camera.halfHeight);
    const float shift = camera.perspective ? 0.5f * z : 0.0f;
    u.depthDecode.z = (x / (2 * half.x) + shift) * float(width);
    u.depthDecode.w = (y / (2 * half.y) + shift) * float(height);
    u.viewDirection.w = z;
    u.directionalDirections[0].w = length;
}

}  // namespace rushlight

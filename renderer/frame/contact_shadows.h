#pragma once
// The ray that shaders/common/contact_shadow.glsl marches along.

#include "interop/frame_uniforms.h"
#include "renderer/frame/view_math.h"

namespace rushlight {

/// `towardsLight` is unit, `length` in metres. Fills what LightingUniforms has of it.
void fillContactShadows(const CameraMatrices& camera, uint32_t width, uint32_t height,
                        const vec3& towardsLight, float length, interop::LightingUniforms& uniforms);

}  // namespace rushlight

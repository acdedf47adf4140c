#pragma once
// What shaders need to know of a shadow view and of a sun's cascades.

#include "interop/frame_uniforms.h"
#include "renderer/shadows/shadow_view.h"
#include "renderer/visibility/shadow_cascades.h"

namespace rushlight {

interop::ViewUniforms makeViewUniforms(const ShadowCascade& cascade);
interop::ViewUniforms makeViewUniforms(const ShadowView& view);

/// What the shaders need to know of a sun's cascades; the fields of LightingUniforms.
struct SunShadow {
    vec4 rows[3]{};
    vec4 cascades[4]{};
    vec4 settings{0};
    vec4 softness{0};
};
SunShadow makeSunShadow(const CameraMatrices& camera, const ShadowCascades& cascades,
                        float angularRadius);

}  // namespace rushlight

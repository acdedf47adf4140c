#pragma once

#include "interop/frame_uniforms.h"
#include "renderer/frame/environment_store.h"
#include "renderer/frame/irradiance_store.h"
#include "renderer/frame/light_clusters.h"
#include "renderer/frame/shadow_cascades.h"
#include "renderer/frame/shadow_view.h"

namespace rushlight {

interop::ViewUniforms makeViewUniforms(const CameraMatrices& camera);
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

/// `sun` is the index of the first light that casts shadows, -1 for none; the lights are in the order of sunOrder().
interop::LightingUniforms makeLightingUniforms(const CameraMatrices& camera,
                                               const Lighting& lighting, int sun,
                                               const LightClusters& clusters,
                                               const ShadowCascades& cascades,
                                               const GpuEnvironment* environment,
                                               const GpuIrradianceVolume* volume);

/// Index of the first directional light that casts shadows, or -1.
int findSun(const Lighting& lighting);

}  // namespace rushlight

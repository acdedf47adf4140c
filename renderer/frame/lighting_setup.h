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

/// `sun` is the index of the light that casts shadows, which the shaders expect first; -1 for none.
interop::LightingUniforms makeLightingUniforms(const CameraMatrices& camera,
                                               const Lighting& lighting, int sun,
                                               const LightClusters& clusters,
                                               const ShadowCascades& cascades,
                                               const GpuEnvironment* environment,
                                               const GpuIrradianceVolume* volume);

/// Index of the first directional light that casts shadows, or -1.
int findSun(const Lighting& lighting);

}  // namespace rushlight

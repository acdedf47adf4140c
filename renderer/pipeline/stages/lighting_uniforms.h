#pragma once

#include "interop/frame_uniforms.h"
#include "renderer/lighting/clusters/light_clusters.h"
#include "renderer/resources/environment_store.h"
#include "renderer/resources/irradiance_store.h"
#include "renderer/shadows/sun_shadow.h"

namespace rushlight {

interop::ViewUniforms makeViewUniforms(const CameraMatrices& camera);
/// `sun` is the index of the first light that casts shadows, -1 for none; the lights are in the
/// order of sunOrder().
interop::LightingUniforms makeLightingUniforms(const CameraMatrices& camera,
                                               const Lighting& lighting, int sun,
                                               const LightClusters& clusters,
                                               const ShadowCascades& cascades,
                                               const GpuEnvironment* environment,
                                               const GpuIrradianceVolume* volume);

}  // namespace rushlight

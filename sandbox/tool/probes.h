#pragma once
// Irradiance probes of a scene: baked, read from a file, or neither.

#include "renderer/lighting/irradiance_volume.h"
#include "renderer/raytrace/probe_bake.h"
#include "renderer/scene_bridge/scene_bridge.h"

#include <optional>
#include <string>

namespace rushlight::tool {

/// SCENE with .probes in place of its extension.
std::string defaultProbePath(const std::string& scene);

/// Bakes what `bridge` shows; reports progress on a terminal, not into a pipe.
Result<IrradianceVolume> bakeProbes(const SceneBridge& bridge, const BakeLighting& lighting,
                                    float spacing, uint32_t samples, JobSystem& jobs);

Result<IrradianceVolume> readProbes(const std::string& path);

}  // namespace rushlight::tool

#pragma once

#include "renderer/raytrace/ray_scene.h"
#include "renderer/scene_bridge/scene_bridge.h"

namespace rushlight {

/// What `bridge` shows, in its present pose, as a scene to shoot rays through: RayHit::instance
/// indexes FrameInput::instances of SceneBridge::fill. `jobs` must outlive it.
Result<std::unique_ptr<RayScene>> makeRayScene(const SceneBridge& bridge, JobSystem& jobs);

}  // namespace rushlight

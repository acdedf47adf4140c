#pragma once

#include "engine/assets/model.h"
#include "renderer/frame/frame_input.h"
#include "renderer/scene_bridge/light_uploads.h"

#include <optional>
#include <string>
#include <vector>

namespace rushlight {

struct SceneLights {
    std::vector<DirectionalLight> directional;
    std::vector<PunctualLight> punctual;
    std::vector<AreaLight> area;
};

/// The lights of the shown nodes in their order, as many as a frame takes; `notes` tells how many
/// are over.
SceneLights lightsOf(const assets::Model&, const LightUploads&, const std::vector<int>& nodes,
                     const std::vector<mat4>& world, std::vector<std::string>& notes);

/// A camera at the node's place and turn; scale is ignored (glTF 2.0, section 3.10).
View viewOf(const assets::Camera&, const mat4& worldFromNode);

}  // namespace rushlight

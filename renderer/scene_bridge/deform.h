#pragma once

#include "engine/assets/model.h"

#include <span>
#include <vector>

namespace rushlight {

/// Vertices after morphing and skinning.
struct DeformedVertices {
    std::vector<vec3> positions;
    std::vector<vec3> normals;
    std::vector<vec4> tangents;
};

/// Adds the morph targets by `weights`, then moves by `joints` (world from bind pose, by
/// Skin::joints; empty: no skin). glTF 2.0, sections 3.7.2.2 and 3.7.3.
void deform(const assets::Geometry&, std::span<const float> weights, std::span<const mat4> joints,
            DeformedVertices& result);

}  // namespace rushlight

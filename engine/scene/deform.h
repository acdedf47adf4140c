#pragma once
// Skinning and morphing on the CPU.

#include "engine/assets/model.h"
#include "engine/scene/pose.h"

#include <vector>

namespace rushlight::scene {

/// The vertices of a geometry after its deformation; `tangents` is empty when the geometry has
/// none.
struct DeformedVertices {
    std::vector<vec3> positions;
    std::vector<vec3> normals;
    std::vector<vec4> tangents;
};

/// Morph targets first, then the skin of `node` (glTF 2.0, sections 3.7.2.2 and 3.7.3). With a skin
/// the result is in world space, whatever the node's own transform; without one it is in the node's
/// local space. `out` keeps its memory from call to call.
void applySkinAndMorph(const assets::Model& model, const Pose& pose, int node,
                       const assets::Geometry& geometry, DeformedVertices& out);

}  // namespace rushlight::scene

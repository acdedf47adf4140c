#pragma once

#include "engine/assets/model.h"

namespace rushlight::assets {

/// Fills Geometry::tangents from positions, normals and uv set 0 or 1, splitting vertices whose
/// triangles do not agree. The method is that of M. Mikkelsen, "Simulation of Wrinkled Surfaces
/// Revisited", 2008, chapter 3, which normal maps are baked for: triangles that meet at a vertex
/// along shared edges with the same handedness share one tangent, the sum of theirs projected into
/// the vertex plane and weighted by the angle of the corner. `w` is negated with respect to that
/// text because v runs down in glTF.
void makeTangents(Geometry& geometry, int uvSet);

}  // namespace rushlight::assets

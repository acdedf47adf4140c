#pragma once

#include "engine/assets/model.h"

#include <cstdint>
#include <vector>

namespace rushlight::assets {

/// Makes `geometry` of its own vertices picked by `source`: vertex i becomes the old vertex
/// source[i].
void gatherVertices(Geometry& geometry, const std::vector<uint32_t>& source);

/// One vertex a corner, with the face's normal (glTF 2.0, section 3.7.2.1: "calculate flat
/// normals").
void makeFlatNormals(Geometry& geometry);

/// Unit normals; one of no length becomes the mean of its faces'.
void repairNormals(Geometry& geometry);

void computeBounds(Geometry& geometry);

}  // namespace rushlight::assets

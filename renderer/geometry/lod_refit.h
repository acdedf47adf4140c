#pragma once
// Where to move the vertices of a simplified surface so that it lies balanced about the original.
// With vertices of the original alone, the chords of everything round run inside it: spheres
// shrink.

#include "renderer/geometry/surface_distance.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rushlight {

/// The vertices of a level alone.
struct LevelSurface {
    std::vector<uint32_t> sources;  ///< as `positions`: which vertex of the mesh each one is
    std::vector<uint32_t> places;   ///< as `positions`: equal for those in one place
    uint32_t placeCount = 0;
    std::vector<vec3> positions, normals;
    std::vector<uint32_t> indices;  ///< into these
};

/// By place, how far to move it so that the mean square of the distance from the level's surface to
/// the original, to the nearest point that is shaded alike, is least. What is flat stays, and so do
/// open borders. A place moves by `farthest` metres at most, and what is farther than that from the
/// original has no say.
std::vector<vec3> refit(const LevelSurface& level, const SurfaceGrid& original, float farthest);

}  // namespace rushlight

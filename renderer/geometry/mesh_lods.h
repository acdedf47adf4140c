#pragma once
// Levels of detail: fewer and fewer triangles, their vertices the mesh's or, where that lies
// closer, moved copies. Each level has about half the triangles of the one before. The topology
// comes from edge collapses on quadric error metrics (Garland and Heckbert, 1997), then, for far
// levels, from vertex clustering (Lindstrom, 2000), both by meshoptimizer.

#include "renderer/frame/frame_input.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rushlight {

struct MeshLod {
    uint32_t firstIndex = 0;
    uint32_t indexCount = 0;
    /// About the largest distance between this level's surface and the nearest of level 0 that
    /// faces the same way, and the reverse; metres in the mesh's local space. 0 for level 0, and no
    /// level has less than the one before.
    float error = 0;
};

inline constexpr uint32_t kMaxLods = 8;
inline constexpr uint32_t kFewestTrianglesForLods = 64;  ///< smaller meshes have level 0 alone
inline constexpr uint32_t kFewestTrianglesOfLod = 12;

/// A vertex that levels have beside the mesh's: all of another's values, in another place.
struct MovedVertex {
    uint32_t source = 0;
    vec3 offset{0};
};

struct LodChain {
    std::array<MeshLod, kMaxLods> lods;  ///< firstIndex 0 is the first of level 0; the others
                                         ///< follow it
    uint32_t count = 1;                  ///< levels, level 0 included
    std::vector<uint32_t> indices;       ///< of levels 1 and up, one after the other
    std::vector<MovedVertex> moved;      ///< numbered on from the mesh's vertices
};

/// The chain of a valid mesh with normals; level 0 is its own indices as they are. `closed` as
/// isClosed() says.
///
/// A chain ends where a level would have fewer than kFewestTrianglesOfLod triangles or more than 85
/// % of those before, would be off by a tenth of the mesh's size, or would cover visibly less: leaf
/// cards do not shrink away. Vertices that differ in position, texture coordinates, colour or
/// handedness stay apart, so that textures do not smear before the clustered levels; of those that
/// differ in the normal alone each triangle takes what faces its way. A seam never opens: what is
/// in one place at level 0, to a millionth of the mesh's size, is so at every level.
LodChain makeLods(const MeshDesc& mesh, bool closed);

}  // namespace rushlight

#pragma once
// The vectorised steps of occlusion culling, compiled for several instruction sets and chosen at
// run time. No fused multiply-adds: every instruction set gives the same bits.

#include "renderer/visibility/occlusion/occlusion_mesh.h"
#include "renderer/visibility/occlusion/occlusion_types.h"

namespace rushlight {

struct ProjectParameters {
    mat4 clipFromLocal;
    float halfWidth, halfHeight;  ///< of the target, pixels
    float nearFactor;             ///< in front of the near plane: not z <= nearFactor * w
    float guardX, guardY;         ///< outside: not |x| <= guardX * w
};

struct ProjectedBounds {
    float leastW;         ///< of the vertices inside; +max where there is none
    float greatestPixel;  ///< |x| or |y| of the vertices inside
    uint32_t outsideAny;  ///< of all vertices
};

/// Writes paddedToLanes(mesh.vertexCount) vertices.
ProjectedBounds projectVertices(const OccluderMesh& mesh, const ProjectParameters&,
                                ScreenVertex* out);

/// Clears a band of kBandRows rows, then fills it with the occluders in their order. Touches no
/// other band.
void fillBand(const DepthTiles& tiles, std::span<const FillList> occluders, uint32_t band);

/// `visible[i]` becomes 1 or 0; a box that reaches in front of the near plane is visible.
void testBoxes(const DepthTiles& tiles, const mat4& clipFromWorld,
               std::span<const OcclusionBox> boxes, uint8_t* visible);

}  // namespace rushlight

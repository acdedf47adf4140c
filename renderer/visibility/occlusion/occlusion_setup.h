#pragma once
// From an occluder's mesh to triangles that can be filled and the outline that must not be relied
// on.

#include "renderer/visibility/occlusion/occlusion_kernels.h"

namespace rushlight {

/// What all occluders of a frame share.
struct OcclusionView {
    mat4 clipFromWorld;
    uint32_t width = 1, height = 1;  ///< pixels
    float nearW = 0;  ///< clip w on the near plane; 0: not the same everywhere, what crosses is
                      ///< left out

    static OcclusionView make(const mat4& clipFromWorld, uint32_t width, uint32_t height);
};

struct Occluder {
    const OccluderMesh* mesh = nullptr;  ///< kept by the caller until rasterize() has returned
    mat4x3 worldFromLocal{1};
    bool twoSided = false;  ///< else triangles that turn clockwise, after mirroring by the
                            ///< transform, hide nothing
};

/// Where one occluder's work goes; room for what `occluderRoom` says.
struct SetupMemory {
    ScreenVertex* vertices;
    float* vertexErrors;
    uint8_t* facings;
    FillTriangle* triangles;
    RowRange* triangleRows;
    uint32_t* sources;  ///< of each triangle to fill: that of the mesh
    OutlineEdge* outline;
};

struct OccluderRoom {
    size_t vertices, meshTriangles, triangles, outline;
};
OccluderRoom occluderRoom(const OccluderMesh&);

/// The result's spans point into `memory`. Nothing to fill where the numbers are too wild to be
/// sure.
FillList setUpOccluder(const OcclusionView&, const Occluder&, const SetupMemory& memory);

}  // namespace rushlight

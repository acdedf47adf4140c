#pragma once
// How large things appear, and which level of detail that asks for.

#include "renderer/geometry/view_math.h"
#include "renderer/resources/geometry_store.h"

#include <algorithm>

namespace rushlight {

/// What a view makes of a metre, and what error it forgives. Pixels are the camera's, or a shadow
/// map's texels.
struct DetailScale {
    vec3 eye{0};
    float pixelsPerMetre = 1;  ///< at one metre's distance; of an orthographic view, everywhere
    float nearest = 0;         ///< metres; nothing is seen from nearer
    bool perspective = false;
    float maxError = 0;  ///< pixels that a simplified surface may be off; 0: no simplification
    float minSize = 0;   ///< pixels across; what is smaller is left out

    /// Pixels of a metre at the nearest point of a sphere.
    float at(const vec3& center, float radius) const {
        if (!perspective) return pixelsPerMetre;
        return pixelsPerMetre / std::max(glm::length(center - eye) - radius, nearest);
    }
};

DetailScale cameraDetail(const CameraMatrices& camera, uint32_t targetHeight);

/// The coarsest level whose error is at most `maxError` metres of the mesh's space.
inline uint32_t pickLod(const GpuMesh& mesh, float maxError) {
    uint32_t lod = 0;
    while (lod + 1 < mesh.lodCount && mesh.lods[lod + 1].error <= maxError) ++lod;
    return lod;
}

/// As pickLod, but a coarser level than `last` is taken only when it is well within the error, so
/// that what stands near the limit does not flicker between two. The error never exceeds
/// `maxError`.
inline uint32_t pickLodSteadily(const GpuMesh& mesh, float maxError, uint32_t last) {
    constexpr float kMargin = 0.8f;
    const uint32_t lod = pickLod(mesh, maxError);
    return lod > last ? std::max(last, pickLod(mesh, maxError * kMargin)) : lod;
}

}  // namespace rushlight

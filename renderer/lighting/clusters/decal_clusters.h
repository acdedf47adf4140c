#pragma once
// Which decals reach into which froxel: the camera's view cut as for lights (light_clusters.h).

#include "renderer/geometry/view_math.h"
#include "renderer/resources/decal_store.h"
#include "shaders/interop/frame_uniforms.h"

#include <span>
#include <vector>

namespace rushlight {

/// As the shaders read it: six texels of RGBA32F. Rows take positions relative to the camera into
/// the decal's box.
struct GpuDecal {
    vec4 rows[3];
    vec4 baseColor;
    float layer;
    float roughness, metallic;
    float baseColorShare;
    float normalShare, roughnessShare;
    float texelsPerMetre;
    float unused = 0;
};
static_assert(sizeof(GpuDecal) == 96);

/// A froxel's record, before all lists:
///
///     31                     8 7         0
///     [ first entry           ][  count  ]
struct DecalClusters {
    static constexpr uint32_t kSlices = RL_DECAL_SLICES;
    static constexpr uint32_t kMaxPerCluster = 255;

    uint32_t tilesX = 1, tilesY = 1;
    float sliceScale = 0, sliceBias = 0;  ///< slice = log2(viewDepth) * scale + bias
    /// As ViewUniforms holds it.
    vec4 mapping() const { return {sliceScale, sliceBias, float(tilesX), float(tilesX * tilesY)}; }

    std::vector<GpuDecal> decals;  ///< the visible ones, in their order
    std::vector<uint32_t> lists;   ///< records, then indices of decals

    /// Fills the lists; keeps the vectors' memory. Decals without a good material or box are left
    /// out.
    void build(const CameraMatrices& camera, uint32_t width, uint32_t height,
               std::span<const Decal> all, const DecalStore& store);

private:
    struct Box {
        vec3 low, high;  ///< in view space: right, up, forward
    };
    struct Reference {
        uint32_t cluster, decal;
    };
    void setSlices(const CameraMatrices&);
    void addReferences(const CameraMatrices&, uint32_t decal, const Box&);

    std::vector<Box> boxes_;
    std::vector<Reference> references_;
    uint32_t width_ = 0, height_ = 0;
    float sliceEdges_[kSlices + 1] = {};
};

}  // namespace rushlight

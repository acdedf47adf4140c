#pragma once
// Clustered light lists: the view volume is cut in froxels (tiles of 64 x 64 pixels, exponential slices of depth), and
// each lists the lights that reach into it (Olsson, Billeter, Assarsson, "Clustered Deferred and Forward Shading", 2012).

#include "renderer/frame/view_math.h"

#include <span>
#include <vector>

namespace rushlight {

/// As the shaders read it: three texels of RGBA32F.
struct GpuLight {
    vec3 position;         ///< relative to the camera, world axes
    float inverseRangeSq;  ///< 0: unbounded
    vec3 intensity;        ///< candela
    float spotScale;       ///< cone falloff = saturate(dot * scale + offset)²; 0 and 1 for a point light
    vec3 direction;        ///< unit, the way a spot shines
    float spotOffset;
};
static_assert(sizeof(GpuLight) == 48);

/// A froxel's list.
///
///     31                    10 9         0
///     [ first light index     ][  count  ]
struct LightClusters {
    static constexpr uint32_t kCountBits = 10;
    static constexpr uint32_t kMaxPerCluster = (1u << kCountBits) - 1;
    static constexpr uint32_t kMaxReferences = 1u << (32 - kCountBits);  ///< of all froxels together
    static constexpr uint32_t kSlices = 16;

    uint32_t tilesX = 1, tilesY = 1;
    float sliceScale = 0, sliceBias = 0;  ///< slice = log2(viewDepth) * scale + bias
    /// As LightingUniforms holds them.
    vec4 mapping() const {
        return {sliceScale, sliceBias, float(tilesX), float(tilesX * tilesY)};
    }
    vec4 counts() const { return {float(tilesX), float(tilesY), float(kSlices), 0}; }

    uint32_t visibleLights = 0;
    /// Lights left out of lists: 0 unless over 1,023 reach one froxel or the lists hold over 4,194,303 together.
    uint32_t droppedReferences = 0;
    std::vector<GpuLight> lights;    ///< the visible ones
    std::vector<uint32_t> clusters;
    std::vector<uint16_t> indices;

    /// Fills the lists; keeps the vectors' memory.
    void build(const CameraMatrices& camera, uint32_t width, uint32_t height,
               std::span<const PunctualLight> punctual);

private:
    struct Reference {
        uint32_t cluster;
        uint16_t light;
    };
    uint32_t fairListLength() const;
    void addReferences(const CameraMatrices&, uint16_t light, const vec3& viewPosition, float range);

    std::vector<Reference> references_;
    std::vector<float> ranges_;
    std::vector<float> sliceEdges_;
    uint32_t width_ = 0, height_ = 0;
};

/// Metres beyond which a light without a range adds less than a thousandth of a lux.
float effectiveRange(const PunctualLight& light);

}  // namespace rushlight

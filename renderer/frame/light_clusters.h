#pragma once
// Clustered light lists: the view volume is cut in froxels (tiles of 64 x 64 pixels, exponential slices of depth), and
// each lists the lights that reach into it (Olsson, Billeter, Assarsson, "Clustered Deferred and Forward Shading", 2012).

#include "renderer/frame/view_math.h"

#include <array>
#include <span>
#include <vector>

namespace rushlight {

/// Lights that need the same work in a shader are listed together and have a loop of their own there.
enum class LightClass : uint8_t {
    plain,      ///< point and spot lights; one slot
    modulated,  ///< those whose light is multiplied by a shadow; two slots
};
inline constexpr uint32_t kLightClasses = 2;

/// A slot of the light buffer as the shaders read it: three texels of RGBA32F. Indices in the lists count slots.
struct GpuLight {
    vec3 position;         ///< relative to the camera, world axes
    float inverseRangeSq;  ///< 0: unbounded
    vec3 intensity;        ///< candela
    float spotScale;       ///< cone falloff = saturate(dot * scale + offset)²; 0 and 1 for a point light
    vec3 direction;        ///< unit, the way a spot shines
    float spotOffset;
};
static_assert(sizeof(GpuLight) == 48);

/// The second slot of a modulated light.
struct GpuLightModulation {
    float shadowRecord = -1;  ///< whole; < 0: casts no shadow
    float radius = 0;         ///< metres
    float unused[10] = {};
};
static_assert(sizeof(GpuLightModulation) == sizeof(GpuLight));

/// The lights of a frame.
struct ClusterInputs {
    std::span<const PunctualLight> punctual;
    /// Of each punctual light, the shadow record that shaders look up, or -1; empty: none has one.
    std::span<const int32_t> shadowRecords;
};

/// A froxel's record: one word in frames of plain lights alone, else two. Its indices are sorted by class and, within
/// one, in the lights' order.
///
///     31                    10 9         0
///     [ first light index     ][  plain  ]
///     [ unused                ][modulated]
struct LightClusters {
    static constexpr uint32_t kCountBits = 10;
    static constexpr uint32_t kMaxPerCluster = (1u << kCountBits) - 1;
    static constexpr uint32_t kMaxReferences = 1u << (32 - kCountBits);  ///< of all froxels together
    static constexpr uint32_t kSlices = 16;

    uint32_t tilesX = 1, tilesY = 1;
    float sliceScale = 0, sliceBias = 0;  ///< slice = log2(viewDepth) * scale + bias
    uint32_t recordWords = 1;
    /// As LightingUniforms holds them.
    vec4 mapping() const {
        return {sliceScale, sliceBias, float(tilesX), float(tilesX * tilesY)};
    }
    vec4 counts() const { return {float(tilesX), float(tilesY), float(kSlices), 0}; }

    uint32_t visibleLights = 0;
    std::array<uint32_t, kLightClasses> visibleOfClass{};
    /// Lights left out of lists: 0 unless over 1,023 of a class reach one froxel or the lists hold over 4,194,303
    /// together.
    uint32_t droppedReferences = 0;
    std::vector<GpuLight> lights;    ///< slots of the visible ones, class by class
    std::vector<uint32_t> clusters;  ///< records
    std::vector<uint16_t> indices;

    /// Fills the lists; keeps the vectors' memory.
    void build(const CameraMatrices& camera, uint32_t width, uint32_t height,
               const ClusterInputs& inputs);

private:
    struct Reference {
        uint32_t list;  ///< froxel * kLightClasses + class
        uint16_t slot;
    };
    struct VisibleLight {
        uint32_t index;  ///< in ClusterInputs
        float range;
        LightClass lightClass;
    };
    void chooseSlices(const CameraMatrices&, float nearest, float farthest);
    void addLight(const CameraMatrices&, const ClusterInputs&, const VisibleLight&);
    uint32_t fairListLength() const;
    void addReferences(const CameraMatrices&, LightClass, uint16_t slot, const vec3& viewPosition,
                       float range);
    void writeLists();

    std::vector<VisibleLight> visible_;
    std::vector<Reference> references_;
    std::vector<uint32_t> lists_;  ///< counts, then next free indices, of each froxel's classes
    std::vector<float> sliceEdges_;
    uint32_t width_ = 0, height_ = 0;
};

/// Metres beyond which a light without a range adds less than a thousandth of a lux.
float effectiveRange(const PunctualLight& light);

}  // namespace rushlight

#pragma once
// Clustered light lists: the view volume is cut in froxels (square tiles of pixels, exponential
// slices of depth), and each lists the lights that reach into it (Olsson, Billeter, Assarsson,
// "Clustered Deferred and Forward Shading", 2012).

#include "engine/core/jobs.h"
#include "renderer/geometry/view_math.h"
#include "renderer/lighting/clusters/light_coverage.h"
#include "renderer/resources/light_pattern_store.h"

#include <array>
#include <span>
#include <vector>

namespace rushlight {

/// Lights that need the same work in a shader are listed together and have a loop of their own
/// there.
enum class LightClass : uint8_t {
    plain,      ///< point and spot lights; one slot
    modulated,  ///< those whose light is multiplied by a shadow, a profile or a cookie; two slots
    area,       ///< surfaces that shine; two slots
};
static_assert(uint32_t(LightClass::area) + 1 == kLightClasses);

/// A slot of the light buffer as the shaders read it: three texels of RGBA32F. Indices in the lists
/// count slots.
struct GpuLight {
    vec3 position;         ///< relative to the camera, world axes
    float inverseRangeSq;  ///< 0: unbounded
    vec3 intensity;        ///< candela
    float spotScale;  ///< cone falloff = saturate(dot * scale + offset)²; 0 and 1 for a point light
    vec3 direction;   ///< unit, the way a spot shines
    float spotOffset;
};
static_assert(sizeof(GpuLight) == 48);

/// The second slot of a modulated light.
struct GpuLightModulation {
    float shadowRecord = -1;        ///< whole; < 0: casts no shadow
    float radius = 0;               ///< metres
    float profile = 0, cookie = 0;  ///< layers of the light patterns, plus one; 0: none
    vec3 right{0};                  ///< of the light's frame, relative position's axes
    float perRadian = 0;            ///< see webAngles() of interop/light_patterns.h
    vec3 up{0};
    float cotangent = 0;  ///< see cookieCoordinates()
};
static_assert(sizeof(GpuLightModulation) == sizeof(GpuLight));

/// The two slots of an area light.
struct GpuAreaLight {
    vec3 position;  ///< relative to the camera, world axes
    float inverseRangeSq;
    vec3 luminance;
    float shape;  ///< AreaShape
    vec3 halfX;
    float radius;
    vec3 halfY;
    float twoSided;           ///< 0 or 1
    float shadowRecord = -1;  ///< whole; < 0: casts no shadow
    float extent = 0;         ///< metres from the middle to the farthest point
    float unused[6] = {};
};
static_assert(sizeof(GpuAreaLight) == 2 * sizeof(GpuLight));

/// The lights of a frame.
struct ClusterInputs {
    std::span<const PunctualLight> punctual;
    /// Of each punctual light, the shadow record that shaders look up, or -1; empty: none has one.
    std::span<const int32_t> shadowRecords;
    std::span<const AreaLight> area;
    std::span<const int32_t> areaShadowRecords = {};  ///< as shadowRecords
    const LightPatternStore* patterns = nullptr;      ///< null: no light has a profile or a cookie
    /// Lights that cast are listed with those that have shadow records, whether or not they are in
    /// view and found room: which classes there are follows from the lights alone.
    bool shadowed = false;
};

/// A froxel's record: one word in frames of plain lights alone, else two. Its indices are sorted by
/// class and, within one, in the lights' order.
///
///     31                    10 9         0
///     [ first light index     ][  plain  ]
///     [ unused    ][  area    ][modulated]     (area lights in bits 10 to 19)
struct LightClusters {
    static constexpr uint32_t kCountBits = 10;
    static constexpr uint32_t kMaxPerCluster = (1u << kCountBits) - 1;
    static constexpr uint32_t kMaxReferences = 1u << (32 - kCountBits);  ///< of all froxels
                                                                         ///< together
    static constexpr uint32_t kMaxSlices = 64;

    uint32_t tilesX = 1, tilesY = 1;
    uint32_t tilePixels = 64;  ///< side of a tile, chosen by how large the lights look
    uint32_t slices = 16;
    float sliceScale = 0, sliceBias = 0;  ///< slice = log2(viewDepth) * scale + bias
    uint32_t recordWords = 1;
    /// As LightingUniforms holds them.
    vec4 mapping() const { return {sliceScale, sliceBias, float(tilesX), float(tilesX * tilesY)}; }
    vec4 counts() const {
        return {float(tilesX), float(tilesY), float(slices), 1 / float(tilePixels)};
    }

    uint32_t visibleLights = 0;
    std::array<uint32_t, kLightClasses> visibleOfClass{};
    std::array<bool, kLightClasses> hasClass{};  ///< among all lights, in view or not
    bool hasPatterns = false;                    ///< some have a profile or a cookie
    /// Lights left out of lists: 0 unless over 1,023 of a class reach one froxel or the lists hold
    /// over 4,194,303 together.
    uint32_t droppedReferences = 0;
    std::vector<GpuLight> lights;    ///< slots of the visible ones, class by class
    std::vector<uint32_t> clusters;  ///< records
    std::vector<uint16_t> indices;

    /// Fills the lists; keeps the vectors' memory. The same lists for any number of threads.
    void build(const CameraMatrices& camera, uint32_t width, uint32_t height,
               const ClusterInputs& inputs, JobSystem& jobs);

private:
    struct VisibleLight {
        uint32_t index;  ///< in ClusterInputs
        LightClass lightClass;
        LightVolume volume;
    };
    void gather(const CameraMatrices&, const ClusterInputs&);
    bool addIfVisible(const CameraMatrices&, uint32_t index, LightClass, LightVolume worldVolume);
    void chooseResolution(const CameraMatrices&, uint32_t width, uint32_t height);
    void chooseGrid(const CameraMatrices&, uint32_t width, uint32_t height);
    /// Lists of a froxel that are counted: one where there are plain lights alone.
    uint32_t listsOfFroxel() const { return recordWords > 1 ? kLightClasses : 1; }
    void addLight(const CameraMatrices&, const ClusterInputs&, VisibleLight&);
    void writeLists(JobSystem&);
    void layOutLists();
    uint32_t fairListLength() const;

    FroxelGrid grid_;
    LightVolumes volumes_;
    std::vector<VisibleLight> visible_;
    float nearest_ = 0, farthest_ = 0;  ///< depths that the visible lights reach
    std::vector<uint32_t> counts_;      ///< of each froxel's classes; then where each list ends
    std::vector<uint32_t> next_;        ///< where each list's next index goes
};

/// Metres beyond which a light without a range adds less than a thousandth of a lux.
float effectiveRange(const PunctualLight& light);
float effectiveRange(const AreaLight& light);
/// The largest area that it shows to any side, square metres.
float shownArea(const AreaLight& light);

}  // namespace rushlight

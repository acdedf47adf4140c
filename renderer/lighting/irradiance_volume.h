#pragma once
// A grid of irradiance probes as data: baked by renderer/raytrace, kept in a file, sampled by the
// lighting shaders.

#include "engine/core/math.h"
#include "engine/core/result.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rushlight {

/// Where the probes are: at `origin + spacing * i`, i below `counts`; x runs fastest.
struct ProbeGrid {
    vec3 origin{0};
    vec3 spacing{1};       ///< metres, positive
    glm::uvec3 counts{1};  ///< at least 1 along each axis

    uint32_t count() const { return counts.x * counts.y * counts.z; }
    vec3 position(uint32_t probe) const {
        return origin + spacing * vec3(probe % counts.x, probe / counts.x % counts.y,
                                       probe / (counts.x * counts.y));
    }
    float smallestSpacing() const { return std::min(spacing.x, std::min(spacing.y, spacing.z)); }
};

inline constexpr uint32_t kMaxProbes = 65536;
inline constexpr uint32_t kProbeDistances = 256;  ///< RL_PROBE_TEXELS squared

/// One probe before it is packed. Radiances in the units of the lights.
struct IrradianceProbe {
    vec3 mean{0};      ///< of the radiance from all around
    mat3 flow{0};      ///< by colour (column): the mean of radiance times direction
    vec3 offset{0};    ///< metres from its place in the grid
    float weight = 1;  ///< 1, or interop::kFilledProbeWeight
};

/// As the GPU reads it; the layout is drawn in shaders/interop/irradiance_volume.h. Immutable once
/// made.
struct IrradianceVolume {
    ProbeGrid grid;
    uint64_t lightHash = 0;      ///< of what it was baked under: hashOf(BakeLighting); 0: of no one
                                 ///< light
    std::vector<uvec4> records;  ///< two a probe
    std::vector<uint32_t> distances;  ///< kProbeDistances a probe: mean and standard deviation as
                                      ///< halves

    IrradianceProbe probe(uint32_t index) const;
    void setProbe(uint32_t index, const IrradianceProbe& probe);
    vec2 distance(uint32_t index, uint32_t texel) const;
    void setDistance(uint32_t index, uint32_t texel, const vec2& meanAndDeviation);
};

/// Zeroed probes on the grid.
IrradianceVolume makeIrradianceVolume(const ProbeGrid& grid);

/// An Error in a sentence when the grid is empty, over kMaxProbes, not finite, or does not fit the
/// data.
Result<void> checkIrradianceVolume(const IrradianceVolume& volume, const std::string& object);

/// Irradiance over pi at a surface point, and in w how much the volume counts there: as the shaders
/// compute it, which know where the eye is (`towardsEye`, unit; zero: not told).
vec4 sampleIrradiance(const IrradianceVolume& volume, const vec3& position, const vec3& normal,
                      const vec3& towardsEye = vec3(0));

/// The distances of all probes as the shaders' atlas: squares of RL_PROBE_TILE texels with borders
/// that repeat what lies beyond, RL_PROBE_ATLAS_ROW in a row.
struct ProbeAtlas {
    uint32_t width = 0, height = 0;
    std::vector<uint32_t> texels;  ///< rg16f
};
ProbeAtlas makeProbeAtlas(const IrradianceVolume& volume);

// The file: a header, then records and distances. Little-endian. A file of another version, cut
// short, too long or with a flipped bit is an Error with the reason.
std::vector<std::byte> encodeIrradianceVolume(const IrradianceVolume& volume);
Result<IrradianceVolume> decodeIrradianceVolume(std::span<const std::byte> bytes,
                                                const std::string& path);

}  // namespace rushlight

#pragma once
// Image-based light, prepared on the CPU: needs no GPU and gives the same bytes for any number of
// threads.

#include "engine/core/jobs.h"
#include "engine/core/result.h"
#include "renderer/frame/frame_input.h"
#include "renderer/lighting/environment/cube_image.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rushlight {

inline constexpr uint32_t kEnvironmentSize = 256;
/// Level i holds roughness i / (kEnvironmentLevels - 1): interop::environmentLevel. Sizes 256 to 8.
inline constexpr uint32_t kEnvironmentLevels = 6;
inline constexpr uint32_t kMaxBackgroundSize = 512;
/// A texel spans 6 degrees; between two, a cosine lobe is a straight line within 0.2 %.
inline constexpr uint32_t kIrradianceSize = 16;

/// A cube map as it is uploaded: RGBA16F, level by level, in a level face by face (GL order), rows
/// from t = 0.
struct CubeTexels {
    uint32_t size = 0;
    uint32_t levels = 0;
    std::vector<uint16_t> halves;

    uint32_t levelSize(uint32_t level) const { return size >> level; }
    /// The texels of one face of one level: 4 * levelSize^2 halves.
    std::span<const uint16_t> face(uint32_t level, uint32_t index) const;
    static size_t halfCount(uint32_t size, uint32_t levels);
};

struct PrefilteredEnvironment {
    /// Irradiance over pi: the radiance of a white Lambert surface. One level. (Nine spherical
    /// harmonics, which are cheaper to store, are wrong by a sixth in a room with windows.)
    CubeTexels irradiance;
    CubeTexels specular;    ///< GGX-prefiltered radiance, kEnvironmentSize, kEnvironmentLevels
    CubeTexels background;  ///< sharp, one level; radiance over 65,504 is clamped here and in
                            ///< specular's level 0
};

/// Hash of all that the result depends on; names the cache file.
uint64_t environmentHash(const EnvironmentDesc& desc);

/// Fails when a side is zero or over 16,384, or when `pixels` is not width * height long. Texels
/// that are negative or not finite count as black.
Result<PrefilteredEnvironment> prefilterEnvironment(const EnvironmentDesc& desc, JobSystem& jobs);

/// The same of a cube of finite radiance, whose side is a power of two and whose borders are
/// filled. Its background has that side too, but at least kEnvironmentSize and at most
/// kMaxBackgroundSize.
PrefilteredEnvironment prefilterCube(CubeLevel source, JobSystem& jobs);

/// Fails when the size, the levels and the number of texels do not fit each other. Texels that are
/// negative or not finite count as black.
Result<PrefilteredEnvironment> convertPrefiltered(const PrefilteredEnvironmentDesc& desc,
                                                  JobSystem& jobs);

}  // namespace rushlight

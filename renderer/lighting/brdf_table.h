#pragma once
// The split-sum table: how much of white light a GGX surface reflects, by angle and roughness.

#include "engine/core/jobs.h"
#include "engine/core/math.h"
#include "interop/brdf.h"

#include <cstdint>
#include <vector>

namespace rushlight {

/// Columns: nDotV, rows: perceptual roughness, both i / (size - 1): a clamped look-up is then exact
/// at roughness 1, where the albedo falls steeply (interop::brdfTableCoordinates). A texel (x, y)
/// means that the directional albedo of the specular lobe is f0 * x + y (interop::specularAlbedo).
/// Format rg16f when uploaded.
struct BrdfTable {
    uint32_t size = 0;
    std::vector<vec2> texels;

    /// Bilinear, as a sampler that clamps to the edge.
    vec2 lookUp(float nDotV, float roughness) const;
    std::vector<uint16_t> halves() const;  ///< two a texel
};

inline constexpr uint32_t kBrdfTableSize = RL_BRDF_TABLE_SIZE;

/// Karis 2013, "Real Shading in Unreal Engine 4", with the exact height-correlated Smith term and
/// sampling of visible normals. The same result for any number of threads.
BrdfTable makeBrdfTable(JobSystem& jobs, uint32_t size = kBrdfTableSize);

/// The two integrals at one point by `samples` samples.
vec2 integrateBrdf(float nDotV, float roughness, uint32_t samples);

}  // namespace rushlight

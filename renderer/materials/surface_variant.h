#pragma once
// Which variant of the surface shaders an instance needs: its material's features, its mesh's
// streams, its transform.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace rushlight {

enum SurfaceFlags : uint32_t {
    kBaseColorTexture = 1u << 0,
    kMetallicRoughnessTexture = 1u << 1,
    kNormalTexture = 1u << 2,
    kOcclusionTexture = 1u << 3,
    kEmissiveTexture = 1u << 4,
    kEmissive = 1u << 5,
    kOcclusionInMetallicRoughness = 1u << 6,  ///< one fetch serves both
    kSecondUv = 1u << 7,
    kUvTransforms = 1u << 8,
    kAlphaMask = 1u << 9,
    kUnlit = 1u << 10,
    kDoubleSided = 1u << 11,
    kMirrored = 1u << 12,  ///< the transform's determinant is negative
    kExtended = 1u << 13,  ///< the mesh has VertexExtra
    kMoving = 1u << 14,
    kBlend = 1u << 15,  ///< drawn over what is behind: alphaMode blend, and what light goes through
    kTransmission = 1u << 16,  ///< with kBlend
    kTransmissionTexture = 1u << 17,
};
inline constexpr uint32_t kSurfaceFlagCount = 18;
// Beside those, of an object as a caster. They change no shader by themselves.
inline constexpr uint32_t kClosedMesh = 1u << 30;
inline constexpr uint32_t kCasts = 1u << 31;
inline constexpr uint32_t kSurfaceFlags = (1u << kSurfaceFlagCount) - 1;
inline constexpr uint32_t kTextureFlags = kBaseColorTexture | kMetallicRoughnessTexture |
                                          kNormalTexture | kOcclusionTexture | kEmissiveTexture |
                                          kTransmissionTexture;

/// The #defines of a variant. The texts are static.
void appendDefines(uint32_t surfaceFlags, std::vector<std::string_view>& defines);

}  // namespace rushlight

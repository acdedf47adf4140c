#pragma once
// Pictures laid over surfaces: dirt, paint, puddles, cracks.

#include "renderer/frame/resource_descs.h"

namespace rushlight {

using DecalMaterialHandle = Handle<struct DecalMaterialTag>;

/// Pictures of one decal, copied. Those of other sizes than kDecalSide squared are resampled to it;
/// an empty one is not there. At most kMaxDecalMaterials.
struct DecalMaterialDesc {
    std::string_view label;
    ImageDesc baseColor = {};  ///< sRGB; alpha is where the decal covers; none: covers all, white
    ImageDesc normal = {};     ///< tangent space, x right, y up in the picture
    ImageDesc metallicRoughness = {};  ///< G roughness, B metallic; none: those of `roughness` and
                                       ///< `metallic` alone
};

inline constexpr uint32_t kDecalSide = 512;
inline constexpr uint32_t kMaxDecalMaterials = 256;

/// A box whose picture is thrown along its -z on every opaque or blended surface within, as far as
/// that faces +z. Later decals lie over earlier ones.
struct Decal {
    mat4x3 worldFromDecal{1.0f};  ///< of the box from -1 to 1; x right and y up in the picture; any
                                  ///< size, not degenerate
    DecalMaterialHandle material;
    vec4 baseColor{1};         ///< linear, times the picture; alpha times its cover
    float roughness = 1;       ///< times the picture's
    float metallic = 0;        ///< times the picture's, which is 1 without one
    float baseColorShare = 1;  ///< how much of each the decal replaces where it covers, 0 to 1
    float normalShare = 1;
    float roughnessShare = 1;  ///< and of metallic
};

inline constexpr uint32_t kMaxDecals = 1024;

}  // namespace rushlight

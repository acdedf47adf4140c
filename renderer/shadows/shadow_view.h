#pragma once
// A view from a light: what its shadow map shows. Shadow maps of point and spot lights are
// perspective and reversed: depth is near / distance along the axis, so that 1 is at the near plane
// and 0 infinitely far.

#include "renderer/geometry/box_block.h"
#include "renderer/visibility/detail.h"

namespace rushlight {

struct ShadowView {
    mat4 clipFromWorld{1};
    CullVolume volume;  ///< what can cast into it
    DetailScale scale;  ///< in texels of the map
    float range = 0;    ///< metres from scale.eye; what is farther casts no shadow
};

/// A face of a light's shadow as the shaders read it: four texels of RGBA32F. With p from the light
/// to the surface and w = dot(forward, p), the place in the atlas is dot(right, p) / w + centre;
/// the depth to compare is near / w.
struct GpuShadowFace {
    vec3 right;  ///< times uv of the atlas per tangent
    float centerU;
    vec3 up;
    float centerV;
    vec3 forward;  ///< unit
    float nearPlane;
    float softLimit;     ///< texels, the widest penumbra's radius: within the border
    float texelTangent;  ///< metres that a texel spans at one metre's distance
    float uvPerTangent;
    float radius;  ///< metres, of the source
};
static_assert(sizeof(GpuShadowFace) == 64);

/// Where a light's faces look: of a cube +x, -x, +y, -y, +z, -z; of a spot, its direction.
struct ShadowFaceDesc {
    vec3 position;
    vec3 right, up, forward;  ///< orthonormal
    float tanHalf = 1;        ///< of half the angle that a receiver may see, without the border
    float nearPlane = 0.05f;
    float range = 0;
    uint32_t texels = 0;   ///< a side, with the border
    uint32_t border = 32;  ///< a side over the border; see shadowBorder()
};

/// Texels on each side of a tile that only filters read: they see past the face's edge. One
/// `share`th of the side.
uint32_t shadowBorder(uint32_t texels, uint32_t share = 32);

/// The basis of a cube's face.
void cubeFaceBasis(uint32_t face, vec3& right, vec3& up, vec3& forward);
/// A basis around a spot's direction.
void spotBasis(const vec3& direction, vec3& right, vec3& up);

/// The tangent of half the angle that the whole tile sees.
float tileTangent(const ShadowFaceDesc& desc);
/// `scale` gets its eye, size and near plane; the limits are the caller's.
void makeShadowView(const ShadowFaceDesc& desc, ShadowView& view);
/// `tileX`, `tileY`: the tile's corner in an atlas of `atlasSize` texels; positions as desc's.
GpuShadowFace makeGpuShadowFace(const ShadowFaceDesc& desc, uint32_t tileX, uint32_t tileY,
                                uint32_t atlasSize, float radius);

}  // namespace rushlight

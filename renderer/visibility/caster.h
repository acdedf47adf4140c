#pragma once
// How an object is drawn into a shadow map.

#include "renderer/materials/surface_variant.h"
#include "renderer/visibility/detail.h"
#include "renderer/visibility/draw_list.h"

namespace rushlight {

/// A caster's shader depends on its material only where alpha cuts it. A closed mesh casts the same
/// shadow with its back faces culled; kDoubleSided stands for "do not cull".
inline uint32_t shadowFlags(uint32_t flags) {
    if (flags & kAlphaMask)
        return kAlphaMask | kDoubleSided |
               (flags & (kBaseColorTexture | kSecondUv | kUvTransforms | kExtended));
    if (!(flags & kClosedMesh) || (flags & kDoubleSided)) return kDoubleSided | (flags & kExtended);
    return flags & (kMirrored | kExtended);
}

/// What colours light needs to be known of by its colour; its backs are left out as those of other
/// casters.
inline uint32_t glassFlags(uint32_t flags) {
    constexpr uint32_t kUsed = kTransmission | kTransmissionTexture | kBaseColorTexture |
                               kMetallicRoughnessTexture | kSecondUv | kUvTransforms | kAlphaMask |
                               kExtended;
    const bool open = !(flags & kClosedMesh) || (flags & kDoubleSided);
    return (flags & kUsed) | (open ? uint32_t(kDoubleSided) : flags & kMirrored);
}

/// Light goes through it and takes its colour. Surfaces that are blended by alpha alone do nothing
/// to light.
inline bool coloursLight(uint32_t flags) { return (flags & kTransmission) && (flags & kCasts); }
inline bool castsShadow(uint32_t flags) { return !(flags & kBlend) && (flags & kCasts); }

/// `texelsPerMetre` as DetailScale::at gives them.
inline VisibleItem makeCaster(uint32_t object, const InstanceRecord& r, const GpuMesh& mesh,
                              float maxError, float texelsPerMetre) {
    VisibleItem item;
    item.object = object;
    const bool glass = r.surfaceFlags & kTransmission;
    item.flags = (glass ? glassFlags(r.surfaceFlags) : shadowFlags(r.surfaceFlags)) & kSurfaceFlags;
    item.lod = uint8_t(pickLod(mesh, maxError / (texelsPerMetre * r.scale)));
    item.key = shadowKey(item.flags, item.flags & (kAlphaMask | kTransmission) ? r.textureSet : 0,
                         r.mesh.index(), item.lod);
    return item;
}

}  // namespace rushlight

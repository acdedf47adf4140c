#include "renderer/geometry/box_block.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/geometry/box_block.cpp"
#include <hwy/foreach_target.h>
// after foreach_target, by Highway's rules
#include <hwy/highway.h>

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace rushlight {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, 16>;

uint64_t bitsOf(Lanes d, hn::Mask<Lanes> mask) {
    uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    uint64_t bits;
    std::memcpy(&bits, bytes, sizeof bits);
    return bits;
}

// A box is outside of a plane when its corner that lies farthest inwards is; which corner that is
// depends on the plane's normal alone (Assarsson and Möller, "Optimized View Frustum Culling
// Algorithms", 2000).
template <bool kInside>
BlockMasks test(const BoxBlock& boxes, const CullVolume& volume) {
    const Lanes d;
    const auto zero = hn::Zero(d);
    BlockMasks masks;
    for (size_t i = 0; i < kBlockSize; i += hn::Lanes(d)) {
        auto nearest = zero, farthest = zero;
        for (uint32_t p = 0; p < volume.count; ++p) {
            const Plane& plane = volume.planes[p];
            auto in = hn::Set(d, plane.offset), out = in;
            for (int axis = 0; axis < 3; ++axis) {
                const float n = plane.normal[axis];
                const auto normal = hn::Set(d, n);
                const float* high = boxes.high[axis] + i;
                const float* low = boxes.low[axis] + i;
                in = hn::MulAdd(normal, hn::Load(d, n >= 0 ? high : low), in);
                if constexpr (kInside)
                    out = hn::MulAdd(normal, hn::Load(d, n >= 0 ? low : high), out);
            }
            nearest = hn::Min(nearest, in);
            if constexpr (kInside) farthest = hn::Min(farthest, out);
        }
        masks.touching |= bitsOf(d, hn::Ge(nearest, zero)) << i;
        if constexpr (kInside) masks.inside |= bitsOf(d, hn::Ge(farthest, zero)) << i;
    }
    return masks;
}

BlockMasks testBoth(const BoxBlock& boxes, const CullVolume& volume) {
    return test<true>(boxes, volume);
}
uint64_t testTouching(const BoxBlock& boxes, const CullVolume& volume) {
    return test<false>(boxes, volume).touching;
}

}  // namespace HWY_NAMESPACE
}  // namespace rushlight
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rushlight {

HWY_EXPORT(testBoth);
HWY_EXPORT(testTouching);

BlockMasks testBoxes(const BoxBlock& boxes, const CullVolume& volume) {
    return HWY_DYNAMIC_DISPATCH(testBoth)(boxes, volume);
}
uint64_t touchingBoxes(const BoxBlock& boxes, const CullVolume& volume) {
    return HWY_DYNAMIC_DISPATCH(testTouching)(boxes, volume);
}

void CullVolume::add(const Plane& plane) {
    if (plane.normal == vec3(0)) return;
    RL_CHECK(count < kMaxPlanes, "a view volume has too many planes");
    planes[count++] = plane;
}

void CullVolume::add(const Frustum& frustum) {
    for (const Plane& plane : frustum.planes) add(plane);
}

// Fourier-Motzkin elimination of the distance along `direction`: planes that face along it stay,
// planes that face against it bound nothing any more, and of each pair of one and the other remains
// the combination that is parallel to it.
void addSwept(CullVolume& volume, const Frustum& seen, const vec3& direction, float margin,
              float behind) {
    const auto addMoved = [&](const vec3& normal, float offset) {
        const float length = glm::length(normal);
        if (!(length > 1e-6f)) return;
        const float back = std::max(glm::dot(normal, direction) / length, 0.0f) * behind;
        volume.add(Plane{normal / length, offset / length + margin + back});
    };
    for (const Plane& kept : seen.planes) {
        if (kept.normal == vec3(0)) continue;
        const float along = glm::dot(kept.normal, direction);
        if (along < 0) continue;
        addMoved(kept.normal, kept.offset);
        for (const Plane& dropped : seen.planes) {
            const float against = -glm::dot(dropped.normal, direction);
            if (against > 0)
                addMoved(kept.normal * against + dropped.normal * along,
                         kept.offset * against + dropped.offset * along);
        }
    }
}

}  // namespace rushlight
#endif

#include "renderer/geometry/facing_groups.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/geometry/facing_groups.cpp"
#include <hwy/foreach_target.h>
// after foreach_target, by Highway's rules
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace rushlight {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, 16>;

// With a triangle's normal n, a point p of its plane and v from the centre to the eye, its back is
// seen where dot(n, v) <= dot(n, p - centre). Of a cone of normals of half-angle θ, to whose axis v
// is at the angle φ, the largest dot(n, v) is |v| cos(φ - θ); with d the least of the right sides,
// all backs are seen where φ >= θ + 90° - asin(d/|v|), which -cos φ >= sin θ - cos θ d/|v| implies.
uint32_t facing(const FacingGroups& groups, const vec4& toEye, float limitScale) {
    const Lanes d;
    const hn::Rebind<int32_t, Lanes> whole;
    const auto load = [&](const auto* from) {
        const hn::Rebind<std::decay_t<decltype(*from)>, Lanes> small;
        return hn::ConvertTo(d, hn::PromoteTo(whole, hn::LoadU(small, from)));
    };
    const auto x = hn::Set(d, toEye.x), y = hn::Set(d, toEye.y), z = hn::Set(d, toEye.z);
    const auto length = hn::Set(d, toEye.w), scale = hn::Set(d, limitScale);
    uint32_t bits = 0;
    for (uint32_t i = 0; i < groups.count; i += uint32_t(hn::Lanes(d))) {
        auto along = hn::Mul(x, load(&groups.axis[0][i]));
        along = hn::MulAdd(y, load(&groups.axis[1][i]), along);
        along = hn::MulAdd(z, load(&groups.axis[2][i]), along);
        along = hn::MulAdd(length, load(&groups.sine[i]), along);
        // What is not a number is not away.
        const auto away = hn::Le(along, hn::Mul(scale, load(&groups.limit[i])));
        uint8_t bytes[8] = {};
        hn::StoreMaskBits(d, hn::Not(away), bytes);
        uint32_t some;
        std::memcpy(&some, bytes, sizeof some);
        bits |= some << i;
    }
    return bits;
}

}  // namespace HWY_NAMESPACE
}  // namespace rushlight
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rushlight {
namespace {

HWY_EXPORT(facing);

uint32_t allOf(uint32_t count) { return (1u << count) - 1; }

}  // namespace

uint32_t groupsFacing(const FacingGroups& groups, const mat4x3& worldFromLocal,
                      const FacingEye& eye) {
    const vec3 &a = worldFromLocal[0], &b = worldFromLocal[1], &c = worldFromLocal[2];
    const vec3 across = glm::cross(b, c);
    const float determinant = glm::dot(a, across);
    const float longest = std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)});
    // Where the transform all but flattens, rounding decides what the inverse says.
    constexpr float kFlat = 1e-3f;
    if (!(determinant * determinant > kFlat * kFlat * longest * longest * longest))
        return allOf(groups.count);
    const vec3 way = vec3(eye) - eye.w * worldFromLocal[3];
    const vec3 local = vec3(glm::dot(across, way), glm::dot(glm::cross(c, a), way),
                            glm::dot(glm::cross(a, b), way)) /
                       determinant;
    const vec3 toEye = local - eye.w * groups.center;
    return HWY_DYNAMIC_DISPATCH(facing)(groups, vec4(toEye, glm::length(toEye)),
                                        eye.w * groups.extent) &
           allOf(groups.count);
}

}  // namespace rushlight
#endif

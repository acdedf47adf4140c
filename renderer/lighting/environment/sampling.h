#pragma once
// Deterministic sample points and the warps from the unit square to directions around +z.

#include "engine/core/math.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rushlight {

/// Van der Corput's sequence in base 2, in [0, 1).
inline float radicalInverse(uint32_t bits) {
    bits = bits << 16 | bits >> 16;
    bits = (bits & 0x55555555u) << 1 | (bits & 0xaaaaaaaau) >> 1;
    bits = (bits & 0x33333333u) << 2 | (bits & 0xccccccccu) >> 2;
    bits = (bits & 0x0f0f0f0fu) << 4 | (bits & 0xf0f0f0f0u) >> 4;
    bits = (bits & 0x00ff00ffu) << 8 | (bits & 0xff00ff00u) >> 8;
    return float(bits >> 8) * 0x1p-24f;
}

/// Point `i` of `count`, centred in its stratum.
inline vec2 hammersley(uint32_t i, uint32_t count) {
    return {(float(i) + 0.5f) / float(count), radicalInverse(i)};
}

/// A normal of GGX as seen from `view` (unit, z > 0): pdf = G1(view) max(view.h, 0) D(h) / view.z.
/// Heitz 2018, "Sampling the GGX Distribution of Visible Normals", JCGT 7(4).
inline vec3 sampleVisibleNormal(const vec3& view, float alpha, const vec2& u) {
    const vec3 stretched = glm::normalize(vec3(alpha * view.x, alpha * view.y, view.z));
    const float length2 = stretched.x * stretched.x + stretched.y * stretched.y;
    const vec3 t1 = length2 > 0 ? vec3(-stretched.y, stretched.x, 0) / std::sqrt(length2)
                                : vec3(1, 0, 0);
    const vec3 t2 = glm::cross(stretched, t1);
    const float radius = std::sqrt(u.x);
    const float phi = 2.0f * kPi * u.y;
    const float p1 = radius * std::cos(phi);
    const float s = 0.5f * (1.0f + stretched.z);
    const float p2 = (1.0f - s) * std::sqrt(std::max(0.0f, 1.0f - p1 * p1)) +
                     s * radius * std::sin(phi);
    const vec3 h = p1 * t1 + p2 * t2 +
                   std::sqrt(std::max(0.0f, 1.0f - p1 * p1 - p2 * p2)) * stretched;
    return glm::normalize(vec3(alpha * h.x, alpha * h.y, std::max(0.0f, h.z)));
}

/// A normal of GGX by D(h) n.h. Walter et al. 2007, equations 35 and 36.
inline vec3 sampleGgxNormal(float alpha2, const vec2& u) {
    const float cosine2 = (1.0f - u.x) / (1.0f + (alpha2 - 1.0f) * u.x);
    const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine2));
    const float phi = 2.0f * kPi * u.y;
    return {sine * std::cos(phi), sine * std::sin(phi), std::sqrt(cosine2)};
}

}  // namespace rushlight

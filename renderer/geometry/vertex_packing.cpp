#include "renderer/geometry/vertex_packing.h"

#include "interop/encode.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

// GL reads snorm16 as max(c / 32767, -1).
int16_t snorm16(float x) { return int16_t(std::lround(std::clamp(x, -1.0f, 1.0f) * 32767.0f)); }

bool isUsable(const vec3& v) {
    const float length2 = glm::dot(v, v);
    return std::isfinite(length2) && length2 > 1e-12f;
}

}  // namespace

// Duff et al. 2017, "Building an Orthonormal Basis, Revisited": no branch, no singularity.
vec3 perpendicular(const vec3& n) {
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    return {1.0f + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
}

std::array<int16_t, 4> packTangentFrame(const vec3& normal, const vec4& tangent) {
    const vec3 n = isUsable(normal) ? glm::normalize(normal) : vec3(0, 0, 1);
    vec3 t = vec3(tangent) - n * glm::dot(n, vec3(tangent));
    t = isUsable(t) ? glm::normalize(t) : perpendicular(n);
    const vec4 frame = interop::encodeTangentFrame(n, vec4(t, tangent.w < 0 ? -1.0f : 1.0f));
    return {snorm16(frame.x), snorm16(frame.y), snorm16(frame.z), snorm16(frame.w)};
}

std::array<int16_t, 4> packTangentFrame(const vec3& normal) {
    return packTangentFrame(normal, vec4(0, 0, 0, 1));
}

}  // namespace rushlight

#pragma once
// The one place that configures and includes GLM. Units: metres, seconds, radians. Right-handed, y
// up.

#include <glm/ext/matrix_transform.hpp>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>

namespace rushlight {

using glm::ivec2;
using glm::mat3;
using glm::mat4;
using glm::mat4x3;  // 4 columns of vec3: an affine transform, 48 bytes
using glm::quat;
using glm::uvec2;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

inline constexpr float kPi = 3.14159265358979323846f;

inline mat4 toMat4(const mat4x3& m) {
    return {vec4(m[0], 0), vec4(m[1], 0), vec4(m[2], 0), vec4(m[3], 1)};
}

/// Applies an affine transform to a point.
inline vec3 transformPoint(const mat4x3& m, const vec3& p) {
    return m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3];
}

/// Applies an affine transform to a direction (no translation, not normalised).
inline vec3 transformVector(const mat4x3& m, const vec3& v) {
    return m[0] * v.x + m[1] * v.y + m[2] * v.z;
}

inline bool isFinite(const vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline bool isFinite(const mat4& m) {
    for (int c = 0; c < 4; ++c)
        if (!isFinite(vec3(m[c])) || !std::isfinite(m[c].w)) return false;
    return true;
}

}  // namespace rushlight

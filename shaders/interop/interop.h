// Lets one source be compiled as GLSL 4.50 and as C++ (GLM). Shared files keep to what both
// languages have: functions of scalars, vectors and structs, `f` suffixes, vectors built from
// components (no swizzles), structs filled field by field. In C++ everything is in
// rushlight::interop.
#ifndef RL_INTEROP_INTEROP_H
#define RL_INTEROP_INTEROP_H

#ifdef GLSL

#define RL_INLINE
#define RL_CONST const
#define RL_OUT(T) out T
#define RL_INOUT(T) inout T
#define RL_INTEROP_BEGIN
#define RL_INTEROP_END

#else

#include "engine/core/math.h"

#define RL_INLINE inline
#define RL_CONST inline constexpr
#define RL_OUT(T) T&
#define RL_INOUT(T) T&
#define RL_INTEROP_BEGIN namespace rushlight::interop {
#define RL_INTEROP_END }

namespace rushlight::interop {
using glm::ivec4;
using glm::mat3;
using glm::mat4;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = glm::uint;

using glm::abs;
using glm::acos;
using glm::atan;
using glm::clamp;
using glm::cos;
using glm::cross;
using glm::dot;
using glm::exp2;
using glm::floor;
using glm::fract;
using glm::inversesqrt;
using glm::length;
using glm::log2;
using glm::max;
using glm::min;
using glm::mix;
using glm::normalize;
using glm::pow;
using glm::sin;
using glm::sqrt;
}  // namespace rushlight::interop

#endif

#endif

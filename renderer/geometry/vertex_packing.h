#pragma once
// Vertex attributes to the compact form of VertexSurface. The decoders are in
// shaders/interop/encode.h.

#include "engine/core/math.h"

#include <array>
#include <cstdint>

namespace rushlight {

/// VertexSurface::frame of a unit normal and a tangent (unit xyz, w = +1 or -1). Lengths other than
/// 1 are accepted; a normal of zero becomes +z, and a tangent of zero or along the normal becomes
/// some perpendicular.
std::array<int16_t, 4> packTangentFrame(const vec3& normal, const vec4& tangent);

/// The frame of a vertex that has no tangent: any perpendicular of the normal, right-handed.
std::array<int16_t, 4> packTangentFrame(const vec3& normal);

/// A unit vector perpendicular to a unit vector.
vec3 perpendicular(const vec3& unit);

}  // namespace rushlight

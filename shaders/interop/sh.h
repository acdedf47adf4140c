// Diffuse environment light as spherical harmonics of order 2.
// Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps".
#ifndef RL_INTEROP_SH_H
#define RL_INTEROP_SH_H

#include "interop/interop.h"

RL_INTEROP_BEGIN

/// Coefficients of the polynomial below, with basis constants, cosine convolution and 1/pi folded in: what it gives
/// is the radiance that a white Lambert surface reflects. xyz = red, green, blue; w is unused.
struct IrradianceSh {
    vec4 constant;
    vec4 y;
    vec4 z;
    vec4 x;
    vec4 xy;
    vec4 yz;
    vec4 zz;
    vec4 xz;
    vec4 xxMinusYy;
};

/// Never negative, though nine coefficients ring around a small bright source.
RL_INLINE vec3 evaluateIrradiance(vec3 n, vec3 constant, vec3 y, vec3 z, vec3 x, vec3 xy, vec3 yz,
                                  vec3 zz, vec3 xz, vec3 xxMinusYy) {
    vec3 linear = constant + y * n.y + z * n.z + x * n.x;
    vec3 mixed = xy * (n.x * n.y) + yz * (n.y * n.z) + xz * (n.x * n.z);
    vec3 squares = zz * (n.z * n.z) + xxMinusYy * (n.x * n.x - n.y * n.y);
    return max(linear + mixed + squares, vec3(0.0f));
}

RL_INLINE vec3 shColor(vec4 c) { return vec3(c.x, c.y, c.z); }

RL_INLINE vec3 evaluateIrradiance(IrradianceSh sh, vec3 n) {
    return evaluateIrradiance(n, shColor(sh.constant), shColor(sh.y), shColor(sh.z), shColor(sh.x),
                              shColor(sh.xy), shColor(sh.yz), shColor(sh.zz), shColor(sh.xz),
                              shColor(sh.xxMinusYy));
}

RL_INTEROP_END

#ifndef GLSL
static_assert(sizeof(rushlight::interop::IrradianceSh) == 144);
#endif

#endif

// Where the pictures of lights hold a direction: photometric webs (IES profiles) and cookies, for
// shaders and paths.
//
// A direction from the light in its own frame: x to the right and y up for who looks along z, the
// way the light shines.
#ifndef RL_INTEROP_LIGHT_PATTERNS_H
#define RL_INTEROP_LIGHT_PATTERNS_H

#include "interop/interop.h"

RL_INTEROP_BEGIN

/// Side of all of them, in texels
#define RL_LIGHT_PATTERN_SIDE 256

RL_CONST float kInverseTwoPi = 0.159154943091895336f;

/// The web's angles: x: horizontal, counter-clockwise from x to y, in turns and repeating, texel k
/// at k / side; y: vertical, from z, times `perRadian`: 0 at the first texel's centre and 1 at the
/// last one's; over 1 there is no light.
RL_INLINE vec2 webAngles(vec3 d, float perRadian) {
    float turn = abs(d.x) + abs(d.y) > 1e-6f ? atan(d.y, d.x) * kInverseTwoPi : 0.0f;
    return vec2(turn, acos(clamp(d.z, -1.0f, 1.0f)) * perRadian);
}

RL_INLINE vec2 webCoordinates(vec2 angles) {
    float side = float(RL_LIGHT_PATTERN_SIDE);
    return vec2(angles.x + 0.5f / side, (min(angles.y, 1.0f) * (side - 1.0f) + 0.5f) / side);
}

/// In a cookie, v from the top. `cotangent` of half the angle that the picture spans; 0: it is
/// around the light, equirectangular, its middle at z.
RL_INLINE vec2 cookieCoordinates(vec3 d, float cotangent) {
    if (cotangent > 0.0f) {
        float scale = 0.5f * cotangent / max(d.z, 1e-4f);
        return vec2(0.5f + d.x * scale, 0.5f - d.y * scale);
    }
    float turn = abs(d.x) + abs(d.z) > 1e-6f ? atan(d.x, d.z) * kInverseTwoPi : 0.0f;
    return vec2(0.5f + turn, acos(clamp(d.y, -1.0f, 1.0f)) * (2.0f * kInverseTwoPi));
}

/// Texels of a cookie in a radian there.
RL_INLINE float cookieTexelsPerRadian(vec3 d, float cotangent) {
    float side = float(RL_LIGHT_PATTERN_SIDE);
    return cotangent > 0.0f ? side * 0.5f * cotangent / max(d.z, 1e-2f)
                            : side * 2.0f * kInverseTwoPi;
}

RL_INTEROP_END

#endif

// Bit layouts of the G-buffer and of vertex frames: the only encoders and decoders of each.
#ifndef RL_INTEROP_ENCODE_H
#define RL_INTEROP_ENCODE_H

#include "interop/interop.h"

RL_INTEROP_BEGIN

RL_INLINE float signNotZero(float x) { return x < 0.0f ? -1.0f : 1.0f; }

/// Nearest integer, halves up: `round` leaves halves to the implementation in GLSL.
RL_INLINE float roundHalfUp(float x) { return floor(x + 0.5f); }

// ---- octahedral directions: Cigolle et al. 2014, "A Survey of Efficient Representations for
// Independent Unit Vectors"

/// A direction, of any length but zero, to the square [-1, 1]^2.
RL_INLINE vec2 encodeOctahedral(vec3 n) {
    float scale = 1.0f / (abs(n.x) + abs(n.y) + abs(n.z));
    float x = n.x * scale;
    float y = n.y * scale;
    if (n.z >= 0.0f) return vec2(x, y);
    return vec2((1.0f - abs(y)) * signNotZero(x), (1.0f - abs(x)) * signNotZero(y));
}

RL_INLINE vec3 decodeOctahedral(vec2 e) {
    float z = 1.0f - abs(e.x) - abs(e.y);
    float fold = max(-z, 0.0f);
    return normalize(vec3(e.x - signNotZero(e.x) * fold, e.y - signNotZero(e.y) * fold, z));
}

// ---- two signed 12-bit numbers in three 8-bit unorm channels
// -----------------------------------------------------
//
//     23         16 15         12 11          8 7           0
//     [   x 11..4  ][   x 3..0   ][  y 11..8   ][   y 7..0   ]     code = 2048 + round(2047 v), so
//     that 0 is exact
//           r             g high        g low          b

RL_INLINE vec3 packSigned12(vec2 v) {
    float x = 2048.0f + roundHalfUp(clamp(v.x, -1.0f, 1.0f) * 2047.0f);
    float y = 2048.0f + roundHalfUp(clamp(v.y, -1.0f, 1.0f) * 2047.0f);
    float xHigh = floor(x * (1.0f / 16.0f));
    float yHigh = floor(y * (1.0f / 256.0f));
    return vec3(xHigh, (x - xHigh * 16.0f) * 16.0f + yHigh, y - yHigh * 256.0f) * (1.0f / 255.0f);
}

RL_INLINE vec2 unpackSigned12(vec3 texel) {
    float r = roundHalfUp(texel.x * 255.0f);
    float g = roundHalfUp(texel.y * 255.0f);
    float b = roundHalfUp(texel.z * 255.0f);
    float gHigh = floor(g * (1.0f / 16.0f));
    float x = r * 16.0f + gHigh;
    float y = (g - gHigh * 16.0f) * 256.0f + b;
    return vec2(x - 2048.0f, y - 2048.0f) * (1.0f / 2047.0f);
}

/// A direction of any length in three 8-bit channels; within 0.06 degrees.
RL_INLINE vec3 packNormal(vec3 n) { return packSigned12(encodeOctahedral(n)); }
RL_INLINE vec3 unpackNormal(vec3 texel) { return decodeOctahedral(unpackSigned12(texel)); }

/// Velocity in texture coordinates per frame, at most one screen, companded by the square root: a
/// still pixel is exactly zero, and steps are finest where motion is slow (2.4e-7 at zero, 1e-3 at
/// a whole screen).
RL_INLINE vec3 packVelocity(vec2 v) {
    return packSigned12(vec2(signNotZero(v.x) * sqrt(abs(v.x)), signNotZero(v.y) * sqrt(abs(v.y))));
}
RL_INLINE vec2 unpackVelocity(vec3 texel) {
    vec2 s = unpackSigned12(texel);
    return vec2(s.x * abs(s.x), s.y * abs(s.y));
}

// ---- emissive radiance in 24 bits, one exponent for three mantissas
// ----------------------------------------------
//
//     23    18 17     11 10     5 4     0
//     [ r 6   ][  g 7   ][  b 6  ][ e 5 ]     channel = mantissa / 2^bits * 2^(e - 15); 0 and 2^-21
//     to 64,512

RL_CONST float kMaxEmissive = 64512.0f;

/// Radiance (clamped to [0, kMaxEmissive]) to three 8-bit unorm channels.
RL_INLINE vec3 packEmissive(vec3 radiance) {
    vec3 c = clamp(radiance, vec3(0.0f), vec3(kMaxEmissive));
    float peak = max(max(c.x, c.z), max(c.y, 3.0e-5f));
    float e = clamp(floor(log2(peak)) + 16.0f, 0.0f, 31.0f);
    float perUnit = exp2(15.0f - e);
    // Rounding up to 64 (128) needs the next exponent; so does a log2 that came out one too small.
    if (max(max(roundHalfUp(c.x * perUnit * 64.0f), roundHalfUp(c.z * perUnit * 64.0f)) * 2.0f,
            roundHalfUp(c.y * perUnit * 128.0f)) >= 128.0f) {
        e = min(e + 1.0f, 31.0f);
        perUnit = exp2(15.0f - e);
    }
    float r = min(roundHalfUp(c.x * perUnit * 64.0f), 63.0f);
    float g = min(roundHalfUp(c.y * perUnit * 128.0f), 127.0f);
    float b = min(roundHalfUp(c.z * perUnit * 64.0f), 63.0f);
    float gHigh = floor(g * (1.0f / 32.0f));
    float bHigh = floor(b * (1.0f / 8.0f));
    return vec3(r * 4.0f + gHigh, (g - gHigh * 32.0f) * 8.0f + bHigh,
                (b - bHigh * 8.0f) * 32.0f + e) *
           (1.0f / 255.0f);
}

RL_INLINE vec3 unpackEmissive(vec3 texel) {
    float first = roundHalfUp(texel.x * 255.0f);
    float second = roundHalfUp(texel.y * 255.0f);
    float third = roundHalfUp(texel.z * 255.0f);
    float r = floor(first * 0.25f);
    float bHigh = floor(second * (1.0f / 8.0f));
    float bHighOnly = second - bHigh * 8.0f;
    float bLow = floor(third * (1.0f / 32.0f));
    float g = (first - r * 4.0f) * 32.0f + bHigh;
    float b = bHighOnly * 8.0f + bLow;
    float unit = exp2(third - bLow * 32.0f - 15.0f);
    return vec3(r * (1.0f / 64.0f), g * (1.0f / 128.0f), b * (1.0f / 64.0f)) * unit;
}

// ---- vertex tangent frame: four snorm16, drawn at VertexSurface in renderer/rhi/resources.h
// -----------------

/// Unit normal; unit tangent with w = +1 or -1, the sign of the bitangent.
RL_INLINE vec4 encodeTangentFrame(vec3 normal, vec4 tangent) {
    vec2 n = encodeOctahedral(normal);
    vec2 t = encodeOctahedral(vec3(tangent.x, tangent.y, tangent.z));
    float y = max(t.y * 0.5f + 0.5f, 1.0f / 32767.0f);  // never zero: zero has no sign
    return vec4(n.x, n.y, t.x, tangent.w < 0.0f ? -y : y);
}

RL_INLINE vec3 decodeFrameNormal(vec4 frame) { return decodeOctahedral(vec2(frame.x, frame.y)); }

RL_INLINE vec4 decodeFrameTangent(vec4 frame) {
    vec3 t = decodeOctahedral(vec2(frame.z, abs(frame.w) * 2.0f - 1.0f));
    return vec4(t.x, t.y, t.z, signNotZero(frame.w));
}

RL_INTEROP_END

#endif

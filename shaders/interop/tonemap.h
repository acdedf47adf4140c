// From linear scene radiance (Rec.709, exposure applied) to linear display colour in [0, 1], and
// the sRGB curve.
#ifndef RL_INTEROP_TONEMAP_H
#define RL_INTEROP_TONEMAP_H

#include "interop/interop.h"

RL_INTEROP_BEGIN

RL_INLINE vec3 saturate3(vec3 c) { return clamp(c, vec3(0.0f), vec3(1.0f)); }

/// Khronos PBR Neutral, https://modelviewer.dev/examples/tone-mapping (Khronos Group 2024): exact
/// up to 0.76 for dielectrics, then compressed towards white.
RL_INLINE vec3 toneMapNeutral(vec3 color) {
    float compressionStart = 0.8f - 0.04f;
    float desaturation = 0.15f;
    float low = min(color.x, min(color.y, color.z));
    float offset = low < 0.08f ? low - 6.25f * low * low : 0.04f;
    vec3 c = color - vec3(offset);
    float peak = max(c.x, max(c.y, c.z));
    if (peak < compressionStart) return c;
    float room = 1.0f - compressionStart;
    float newPeak = 1.0f - room * room / (peak + room - compressionStart);
    float towardsWhite = 1.0f - 1.0f / (desaturation * (peak - newPeak) + 1.0f);
    return mix(c * (newPeak / peak), vec3(newPeak), towardsWhite);
}

/// ACES in Stephen Hill's fit (BakingLab, 2016) of RRT and ODT, on radiance / 0.6 as three.js and
/// the Khronos viewer.
RL_INLINE vec3 toneMapAces(vec3 color) {
    mat3 intoAces = mat3(0.59719f, 0.07600f, 0.02840f,  //
                         0.35458f, 0.90834f, 0.13383f,  //
                         0.04823f, 0.01566f, 0.83777f);
    mat3 fromAces = mat3(1.60475f, -0.10208f, -0.00327f,  //
                         -0.53108f, 1.10813f, -0.07276f,  //
                         -0.07367f, -0.00605f, 1.07602f);
    vec3 v = intoAces * (color * (1.0f / 0.6f));
    vec3 a = v * (v + vec3(0.0245786f)) - vec3(0.000090537f);
    vec3 b = v * (v * 0.983729f + vec3(0.4329510f)) + vec3(0.238081f);
    return saturate3(fromAces * (a / b));
}

/// AgX's base transform (Troy Sobotka): inset, log2 from -12.47393 to 4.026069 stops, and the
/// polynomial fit of the curve by Wrensch 2023, "Minimal AgX Implementation"; the result is
/// linearised with the 2.2 power that AgX assumes.
RL_INLINE vec3 toneMapAgx(vec3 color) {
    mat3 inset = mat3(0.842479062253094f, 0.0423282422610123f, 0.0423756549057051f,  //
                      0.0784335999999992f, 0.878468636469772f, 0.0784336f,           //
                      0.0792237451477643f, 0.0791661274605434f, 0.879142973793104f);
    mat3 outset = mat3(1.19687900512017f, -0.0528968517574562f, -0.0529716355144438f,  //
                       -0.0980208811401368f, 1.15190312990417f, -0.0980434501171241f,  //
                       -0.0990297440797205f, -0.0989611768448433f, 1.15107367264116f);
    float lowStop = -12.47393f;
    float highStop = 4.026069f;
    vec3 stops = log2(max(inset * color, vec3(1e-10f)));
    vec3 x = saturate3((stops - vec3(lowStop)) * (1.0f / (highStop - lowStop)));
    vec3 x2 = x * x;
    vec3 x4 = x2 * x2;
    vec3 curve = x4 * x2 * 15.5f - x4 * x * 40.14f + x4 * 31.96f - x2 * x * 6.868f + x2 * 0.4298f +
                 x * 0.1191f - vec3(0.00232f);
    return pow(max(outset * curve, vec3(0.0f)), vec3(2.2f));
}

/// IEC 61966-2-1.
RL_INLINE float encodeSrgb(float x) {
    return x <= 0.0031308f ? x * 12.92f : 1.055f * pow(x, 1.0f / 2.4f) - 0.055f;
}
RL_INLINE vec3 encodeSrgb(vec3 c) {
    return vec3(encodeSrgb(c.x), encodeSrgb(c.y), encodeSrgb(c.z));
}
RL_INLINE float decodeSrgb(float x) {
    return x <= 0.04045f ? x * (1.0f / 12.92f) : pow((x + 0.055f) * (1.0f / 1.055f), 2.4f);
}
RL_INLINE vec3 decodeSrgb(vec3 c) {
    return vec3(decodeSrgb(c.x), decodeSrgb(c.y), decodeSrgb(c.z));
}

/// Interleaved gradient noise (Jimenez 2014), uniform in [0, 1), made triangular in (-1, 1):
/// rounding then adds noise of constant strength. A function of the pixel alone: the same picture
/// every time.
RL_INLINE float ditherNoise(vec2 pixel) {
    float uniformNoise = fract(52.9829189f * fract(dot(pixel, vec2(0.06711056f, 0.00583715f))));
    float centred = uniformNoise * 2.0f - 1.0f;
    float size = 1.0f - sqrt(1.0f - abs(centred));
    return centred < 0.0f ? -size : size;
}

/// A colour to be rounded to 8 bits, at a pixel's centre. Never off the ends: black stays black,
/// white white.
RL_INLINE vec3 dithered(vec3 encoded, vec2 pixel) {
    vec3 room = min(encoded, vec3(1.0f) - encoded) * 255.0f;
    vec3 noise = vec3(ditherNoise(pixel));
    return encoded + clamp(noise, -room, room) * (1.0f / 255.0f);
}

/// Rec.709 luminance of a linear colour.
RL_INLINE float luminance(vec3 c) { return dot(c, vec3(0.2126f, 0.7152f, 0.0722f)); }

RL_INTEROP_END

#endif

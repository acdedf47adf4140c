// Ambient occlusion by horizons: the closed integrals over one slice, for the GPU pass and for
// tests.
//
// Jimenez, Wu, Pesce and Jarabo 2016, "Practical Real-Time Strategies for Accurate Indirect
// Occlusion". A slice is a half-plane pair through the view vector; an angle t in it counts from
// the view vector, n is that of the normal as projected into the slice. Light from between the
// horizons h0 <= 0 <= h1 arrives with the density cos(t - n) |sin t|. With c = cos h and s = sin h
// (of the side's sign) the integrals from 0 to h are, up to a constant that is the same for every h
// of a side:
//
//     of 1:        (cos n s^2 + sin n (h - s c)) / 2
//     of sin t:    (cos n s^3 - sin n (3 c - c^3)) / 3      (the part of the direction across the
//     view) of cos t:    (sin n s^3 - cos n c^3) / 3              (the part along the view)
//
// and both sides have the same form. Against open sky h = n +- pi/2.
#ifndef RL_INTEROP_OCCLUSION_ARC_H
#define RL_INTEROP_OCCLUSION_ARC_H

#include "interop/interop.h"

RL_INTEROP_BEGIN

RL_CONST float kHalfPi = 1.57079632679489662f;

/// Arc cosine within 7e-5, with acos(-x) = pi - acos(x) exactly. Abramowitz and Stegun
/// 1964, 4.4.45.
RL_INLINE float arcCosine(float x) {
    float a = abs(x);
    float r = sqrt(max(1.0f - a, 0.0f)) *
              (1.5707288f + a * (-0.2121144f + a * (0.0742610f - a * 0.0187293f)));
    return x < 0.0f ? 2.0f * kHalfPi - r : r;
}

/// One horizon: x: the light, y: its part across the view, z: along the view; see above.
RL_INLINE vec3 arcIntegrals(float h, float c, float s, float cosN, float sinN) {
    float c3 = c * c * c;
    float s3 = s * s * s;
    return vec3(0.5f * (cosN * s * s + sinN * (h - s * c)),
                (cosN * s3 - sinN * (3.0f * c - c3)) * (1.0f / 3.0f),
                (sinN * s3 - cosN * c3) * (1.0f / 3.0f));
}

/// What a slice loses against open sky to horizons with these cosines, cosH1 on the side of the
/// tangent, cosH0 opposite.
RL_INLINE vec3 arcOccluded(float cosH0, float cosH1, float cosN, float sinN) {
    float n = kHalfPi - arcCosine(sinN);
    float sinH0 = -sqrt(max(1.0f - cosH0 * cosH0, 0.0f));
    float sinH1 = sqrt(max(1.0f - cosH1 * cosH1, 0.0f));
    return arcIntegrals(n + kHalfPi, -sinN, cosN, cosN, sinN) +
           arcIntegrals(n - kHalfPi, sinN, -cosN, cosN, sinN) -
           arcIntegrals(arcCosine(cosH1), cosH1, sinH1, cosN, sinN) -
           arcIntegrals(-arcCosine(cosH0), cosH0, sinH0, cosN, sinN);
}

// ---- a texel of the occlusion image
// ------------------------------------------------------------------------------
//
//     r, g, b   what is missing of  integral of direction * cosine / pi = 2/3 normal,  world axes
//     a         31            10 9          0     device depth, its lower bits replaced; 0:
//     background
//               [ depth         ][ visible   ]

/// Of open sky: the length of the vector that r, g, b are subtracted from.
RL_CONST float kOpenSkyLength = 0.666666667f;

RL_INTEROP_END

#endif

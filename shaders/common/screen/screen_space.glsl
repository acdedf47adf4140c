// ScreenUniforms as flat varyings of a full-screen triangle, and where a texel of the depth buffer is in view space.
// Flat varyings: on llvmpipe fragments read a uniform block three times slower.
#include "interop/bindings.h"
#include "interop/screen_uniforms.h"

#if defined(VERTEX_STAGE)
#define SCREEN_VARYING out
#else
#define SCREEN_VARYING in
#endif

layout(location = 0) flat SCREEN_VARYING vec4 flatViewFromTexel;
layout(location = 1) flat SCREEN_VARYING vec4 flatDepthDecode;
layout(location = 2) flat SCREEN_VARYING vec4 flatSize;
layout(location = 3) flat SCREEN_VARYING vec4 flatRight;
layout(location = 4) flat SCREEN_VARYING vec4 flatUp;
layout(location = 5) flat SCREEN_VARYING vec4 flatBack;
layout(location = 6) flat SCREEN_VARYING vec4 flatSettings;

#if !defined(VERTEX_STAGE)

// Metres from the eye along its view; of the background, very far.
float viewDepthOf(float depth) {
    float linear = depth * flatDepthDecode.x + flatDepthDecode.y;
#if defined(ORTHOGRAPHIC)
    return linear;
#else
    return 1.0 / max(linear, 1e-9);
#endif
}

// `texel`: in texels of the full-size image, centres at halves.
vec3 viewPosition(vec2 texel, float viewDepth) {
    vec2 xy = texel * flatViewFromTexel.xy + flatViewFromTexel.zw;
#if defined(ORTHOGRAPHIC)
    return vec3(xy, -viewDepth);
#else
    return vec3(xy * viewDepth, -viewDepth);
#endif
}

vec3 viewFromWorld(vec3 v) {
    return vec3(dot(flatRight.xyz, v), dot(flatUp.xyz, v), dot(flatBack.xyz, v));
}

vec3 worldFromView(vec3 v) {
    return flatRight.xyz * v.x + flatUp.xyz * v.y + flatBack.xyz * v.z;
}

#endif

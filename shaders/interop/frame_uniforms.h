// Uniform blocks that C++ fills and GLSL reads. std140-safe: vec4 and mat4 alone.
#ifndef RL_INTEROP_FRAME_UNIFORMS_H
#define RL_INTEROP_FRAME_UNIFORMS_H

#include "interop/interop.h"

RL_INTEROP_BEGIN

#define RL_MAX_CASCADES 4
#define RL_MAX_DIRECTIONAL_LIGHTS 4

// RL_UNIFORMS_VIEW, for passes that draw geometry: the camera's, or a cascade's.
struct ViewUniforms {
    mat4 clipFromWorld;
    mat4 previousClipFromWorld;
    vec4 cameraPosition;  // world; w: 1 for a perspective view, 0 for an orthographic one
    vec4 cameraForward;   // world, unit
};

// RL_UNIFORMS_LIGHTING. "Relative" positions are world axes with the camera at the origin.
struct LightingUniforms {
    // A pixel at uv lies at  base + ray * viewDepth,  ray = corner + right * u + up * v  (base likewise).
    vec4 rayCorner, rayRight, rayUp;
    vec4 baseCorner, baseRight, baseUp;
    // x, y: perspective viewDepth = 1 / (depth * x + y), orthographic viewDepth = depth * x + y
    vec4 depthDecode;
    vec4 viewDirection;  // xyz: where an orthographic camera looks
    // slice = log2(viewDepth) * x + y; z: tiles in a row, w: tiles in a slice
    vec4 clusterMapping;
    vec4 clusterCounts;  // x, y, z: froxels along each axis; w: 1 / pixels along a tile's side
    vec4 shadowRows[3];  // relative position to light space: xy metres, z in [0, 1], 1 nearest to the light
    vec4 shadowCascades[RL_MAX_CASCADES];  // x: uv per metre, yz: uv offset, w: metres per texel
    vec4 shadowSettings;                   // x: cascades, y: texels of one, z: 1 / y
    vec4 directionalDirections[RL_MAX_DIRECTIONAL_LIGHTS];    // xyz: towards the light
    vec4 directionalIlluminances[RL_MAX_DIRECTIONAL_LIGHTS];  // rgb: lux
    vec4 environment;     // x, y: cosine and sine of its rotation, z: intensity, w: last mip of the prefiltered cube
    vec4 ambientSky;      // rgb
    vec4 ambientGround;   // rgb
    vec4 background;      // rgb, a: 0 where the picture is to be transparent
};

RL_INTEROP_END

#ifndef GLSL
static_assert(sizeof(rushlight::interop::ViewUniforms) == 160);
static_assert(sizeof(rushlight::interop::LightingUniforms) == 16 * (10 + 3 + 4 + 1 + 8 + 4));
#endif

#endif

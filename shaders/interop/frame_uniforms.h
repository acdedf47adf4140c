// Uniform blocks that C++ fills and GLSL reads. std140-safe: vec4 and mat4 alone.
#ifndef RL_INTEROP_FRAME_UNIFORMS_H
#define RL_INTEROP_FRAME_UNIFORMS_H

#include "interop/interop.h"

RL_INTEROP_BEGIN

#define RL_MAX_CASCADES 4
#define RL_MAX_DIRECTIONAL_LIGHTS 4
// Of a cascade: texels at its rim that filters need, and the share of its side over which it fades
// into the next.
#define RL_SHADOW_RIM 3
#define RL_SHADOW_RIM_SOFT 18
#define RL_CASCADE_BAND 0.05
// The steepest tangent of a receiver's plane against the light that filters follow
#define RL_STEEPEST_RECEIVER 20.0f
// Side of the fog's froxels in pixels, their slices, and how many of these lie side by side in a
// row of their image
#define RL_FOG_PIXELS 16
#define RL_FOG_SLICES 64
#define RL_FOG_COLUMNS 8
// Side of the decals' froxels in pixels, and their slices
#define RL_DECAL_PIXELS 64
#define RL_DECAL_SLICES 16
// The most that a half float holds: brighter light is cut off there, not made infinite.
#define RL_MAX_RADIANCE 65504.0

// RL_UNIFORMS_VIEW, for passes that draw geometry: the camera's, or a cascade's.
struct ViewUniforms {
    mat4 clipFromWorld;
    mat4 previousClipFromWorld;
    vec4 cameraPosition;  // world; w: 1 for a perspective view, 0 for an orthographic one
    vec4 cameraForward;   // world, unit
    vec4 decalMapping;    // slice = log2(viewDepth) * x + y; z: tiles in a row, w: tiles in a slice
    vec4 decalScale;      // x: metres of a pixel, at one metre if the view is perspective
};

// RL_UNIFORMS_LIGHTING. "Relative" positions are world axes with the camera at the origin.
struct LightingUniforms {
    // A pixel at uv lies at  base + ray * viewDepth,  ray = corner + right * u + up * v  (base
    // likewise).
    vec4 rayCorner, rayRight, rayUp;
    vec4 baseCorner, baseRight, baseUp;
    // x, y: perspective viewDepth = 1 / (depth * x + y), orthographic viewDepth = depth * x + y
    // z: metres of contact shadows
    vec4 depthDecode;
    vec4 viewDirection;  // xyz: where the camera looks
    // slice = log2(viewDepth) * x + y; z: tiles in a row, w: tiles in a slice
    vec4 clusterMapping;
    vec4 clusterCounts;  // x, y, z: froxels along each axis; w: 1 / pixels along a tile's side
    vec4 shadowRows[3];  // relative position to light space: xy metres, z in [0, 1], 1 nearest to
                         // the light
    vec4 shadowCascades[RL_MAX_CASCADES];  // x: uv per metre, yz: uv offset, w: metres per texel
    vec4 shadowSettings;  // x: depth per metre, y: texels of one, z: 1 / y, w: 1 / uv over which
                          // the last fades out
    vec4 shadowSoftness;  // x: metres of penumbra per depth between caster and surface
    vec4 directionalDirections[RL_MAX_DIRECTIONAL_LIGHTS];    // xyz: towards the light
    vec4 directionalIlluminances[RL_MAX_DIRECTIONAL_LIGHTS];  // rgb: lux
    vec4 environment;     // x, y: cosine and sine of its rotation, z: intensity, w: last mip of the
                          // prefiltered cube
    vec4 ambientSky;      // rgb
    vec4 ambientGround;   // rgb
    vec4 background;      // rgb, a: 0 where the picture is to be transparent
    vec4 volumeOrigin;    // irradiance probes: xyz: the first, relative position; w: metres that
                          // points go off surfaces
    vec4 volumeScale;     // xyz: 1 / spacing
    vec4 volumeLast;      // xyz: number of the last probe along each axis
    vec4 volumeOuter[3];  // beyond them, by colour: x: mean radiance, yzw: mean of radiance times
                          // direction
    vec4 volumeOuterLuminance;  // the same of luminance; yzw over x
    vec4 fogMedium;   // x: extinction per metre at the eye's height, y: falloff per metre, z:
                      // anisotropy
    vec4 fogAlbedo;   // rgb
    vec4 fogMapping;  // slice = log2(viewDepth) * x + y, from 1 at z; w: the farthest view depth
    vec4 fogGrid;     // xy: tiles, zw: 1 / pixels of the target
    vec4 sunDisk;     // xyz: towards it, w: cosine of its radius
    vec4 sunDiskRadiance;  // rgb
};

RL_INTEROP_END

#ifndef GLSL
static_assert(sizeof(rushlight::interop::ViewUniforms) == 192);
static_assert(sizeof(rushlight::interop::LightingUniforms) ==
              16 * (10 + 3 + 4 + 2 + 8 + 4 + 7 + 6));
#endif

#endif

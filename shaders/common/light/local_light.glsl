// The light around a pixel, from the image of half the size that passes/lighting/irradiance.frag made.
#include "interop/irradiance_volume.h"

layout(binding = RL_TEXTURE_LOCAL_TINT) uniform sampler2D localTintMap;
layout(binding = RL_TEXTURE_LOCAL_FLOW) uniform sampler2D localFlowMap;

// Bilinear among texels of about the pixel's depth: 2 x 2 of them, each of the pixel with even coordinates.
void localLight(vec2 pixel, float viewDepth, out vec3 tint, out vec3 flow) {
    ivec2 size = textureSize(localTintMap, 0);
    ivec2 low = ivec2(pixel) >> 1;
    ivec2 high = min(low + 1, size - 1);
    vec2 f = vec2(ivec2(pixel) & 1) * 0.5;
    vec4 t00 = texelFetch(localTintMap, low, 0);
    vec4 t10 = texelFetch(localTintMap, ivec2(high.x, low.y), 0);
    vec4 t01 = texelFetch(localTintMap, ivec2(low.x, high.y), 0);
    vec4 t11 = texelFetch(localTintMap, high, 0);
    vec4 depths = vec4(t00.a, t10.a, t01.a, t11.a);
    vec4 apart = abs(depths / viewDepth - 1.0) + vec4(equal(depths, vec4(0.0))) * 1e3;
    vec4 w = vec4((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y);
    w = (w + 1e-3) / (apart * apart + 1e-5);
    w *= 1.0 / (w.x + w.y + w.z + w.w);
    tint = t00.rgb * w.x + t10.rgb * w.y + t01.rgb * w.z + t11.rgb * w.w;
    // One bilinear read where the weights have their centre: nearly the same mean.
    vec2 at = vec2(low) + 0.5 + vec2(w.y + w.w, w.z + w.w);
    flow = textureLod(localFlowMap, at / vec2(size), 0.0).rgb * (255.0 / 127.0) - (128.0 / 127.0);
}

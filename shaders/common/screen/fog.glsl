// The fog's froxels: slices of view depth, slice 0 from the eye to L_FOG_MAPPING.z, then exponential. Their image holds
// what the fog adds (rgb) and covers (a), summed from the eye to a slice's far end. (What it lets through would be near 1, where
// half floats are coarse.)
#include "interop/bindings.h"
#include "interop/frame_uniforms.h"

float fogSliceDepth(float slice) {
    return slice < 1.0 ? slice * L_FOG_MAPPING.z
                       : exp2((slice - L_FOG_MAPPING.y) / L_FOG_MAPPING.x);
}

float fogSlice(float viewDepth) {
    return viewDepth < L_FOG_MAPPING.z ? viewDepth / L_FOG_MAPPING.z
                                       : log2(viewDepth) * L_FOG_MAPPING.x + L_FOG_MAPPING.y;
}

/// Extinction between two heights above the eye, times a length: the closed form of exponential height fog.
float fogOpticalDepth(float low, float high, float length) {
    float k = L_FOG_MEDIUM.y;
    float d = k * (high - low);
    // (1 - exp(-d)) / d, by its series where that cancels
    float mean = abs(d) < 1e-3 ? 1.0 - 0.5 * d : (1.0 - exp(-d)) / d;
    return min(L_FOG_MEDIUM.x * exp(min(-k * low, 60.0)) * mean * length, 1e4);
}

/// 1 - exp(-depth), exact for thin fog too
float fogCover(float depth) {
    return depth < 0.01 ? depth * (1.0 - depth * (0.5 - depth / 6.0)) : 1.0 - exp(-depth);
}

/// One stretch of fog in front of another: a before b.
vec4 fogBefore(vec4 a, vec4 b) { return a + (1.0 - a.a) * b; }

#if defined(FOG_LOOKUP)
layout(binding = RL_TEXTURE_FOG) uniform sampler2D fogMap;

vec4 fogTexel(float slice, vec2 place) {
    if (slice < 0.0) return vec4(0.0);
    vec2 cell = vec2(mod(slice, float(RL_FOG_COLUMNS)), floor(slice / float(RL_FOG_COLUMNS)));
    vec2 grid = L_FOG_GRID.xy;
    vec2 image = grid * vec2(float(RL_FOG_COLUMNS), float(RL_FOG_SLICES / RL_FOG_COLUMNS));
    return textureLod(fogMap, (cell * grid + place) / image, 0.0);
}

/// Up to a view depth, or to the end of the slices.
vec4 fogUpTo(vec2 pixel, float viewDepth) {
    vec2 place = clamp(pixel / float(RL_FOG_PIXELS), vec2(0.5), L_FOG_GRID.xy - 0.5);
    float slice = clamp(fogSlice(viewDepth), 0.0, float(RL_FOG_SLICES));
    float last = min(floor(slice), float(RL_FOG_SLICES) - 1.0);
    return mix(fogTexel(last - 1.0, place), fogTexel(last, place), slice - last);
}

/// All fog on the way to the point base + ray * viewDepth. Beyond the slices it goes on with the light of the last one.
vec4 fogAt(vec2 pixel, vec3 base, vec3 ray, float viewDepth) {
    vec4 fog = fogUpTo(pixel, viewDepth);
    float farthest = L_FOG_MAPPING.w;
    if (viewDepth > farthest) {
        vec2 place = clamp(pixel / float(RL_FOG_PIXELS), vec2(0.5), L_FOG_GRID.xy - 0.5);
        vec4 before = fogTexel(float(RL_FOG_SLICES) - 2.0, place);
        // What the last slice added, as the radiance of an endless one
        vec3 endless = (fog.rgb - before.rgb) / max(fog.a - before.a, 1e-6);
        float covered =
            fogCover(fogOpticalDepth(base.y + ray.y * farthest, base.y + ray.y * viewDepth,
                                     length(ray) * (viewDepth - farthest)));
        fog = fogBefore(fog, vec4(endless, 1.0) * covered);
    }
    return fog;
}
#endif

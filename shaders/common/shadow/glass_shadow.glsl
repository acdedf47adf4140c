// Light that comes through coloured glass: what filterShadow is for opaque casters. A map of the same layout holds the product
// of all that light goes through, and where it first does; what is before that is not coloured, and neither is the first
// glass itself. Between the first and the last the product is too dark.
#if defined(SUN_GLASS)
#define SunShare vec3
layout(binding = RL_TEXTURE_SUN_GLASS) uniform sampler2DArray sunGlass;
#else
#define SunShare float
#endif
#if defined(ATLAS_GLASS)
#define LampShare vec3
layout(binding = RL_TEXTURE_ATLAS_GLASS) uniform sampler2DArray atlasGlass;
#else
#define LampShare float
#endif

#if defined(SUN_GLASS) || defined(ATLAS_GLASS)
#include "common/shadow/glass_depth.glsl"

// Depths of the 2x2 texels around a place, in textureGather's order, less those of the surface's plane there; above 0
// before it for sure.
vec4 glassBefore(sampler2DArray map, ShadowLookup at, vec2 offset, bool parallel) {
    vec2 place = at.uv * at.size + offset;
    vec2 low = floor(place - 0.5) + 0.5 - at.uv * at.size;
    vec4 plane = at.reference + dot(at.slope, low) + at.slope.x * vec4(0.0, 1.0, 1.0, 0.0) +
                 at.slope.y * vec4(1.0, 1.0, 0.0, 0.0);
    vec4 kept = textureGather(map, vec3(place * at.texelSize, at.layer), 3);
    return decodeGlassDepths(kept, parallel) - beforePlane(plane, parallel);
}

// Texels without glass are white, so that one linear read is right at outlines too.
vec3 glassTap(sampler2DArray map, ShadowLookup at, vec2 offset, bool parallel) {
    vec4 before = glassBefore(map, at, offset, parallel);
    vec3 color = textureLod(map, vec3(at.uv + offset * at.texelSize, at.layer), 0.0).rgb;
    return any(greaterThan(before, vec4(0.0))) ? color : vec3(1.0);
}

#if defined(SHADOW_SOFT)

vec3 filterGlass(sampler2DArray map, ShadowLookup at, bool parallel) {
    float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    const float least = 1.5;
    float reach = clamp((1.0 - at.reference) * at.softness, least, at.limit);
    float sum = 0.0, count = 0.0;
    for (int i = 0; i < 8; ++i) {
        vec4 before = glassBefore(map, at, diskPoint(i, 8.0, turn) * reach, parallel);
        vec4 colours = vec4(greaterThan(before, vec4(0.0)));
        sum += dot(before, colours);
        count += dot(colours, vec4(1.0));
    }
    if (count == 0.0) return vec3(1.0);
    float radius = clamp(sum / count * at.softness, least, at.limit);
    vec3 share = vec3(0.0);
    for (int i = 0; i < 12; ++i) share += glassTap(map, at, diskPoint(i, 12.0, turn) * radius, parallel);
    return share * (1.0 / 12.0);
}

#elif defined(SHADOW_HARD)

vec3 filterGlass(sampler2DArray map, ShadowLookup at, bool parallel) {
    return glassTap(map, at, vec2(0.0), parallel);
}

#else

// The tent of filterShadow: each block of 2x2 texels by one read where its weights have their middle.
vec3 filterGlass(sampler2DArray map, ShadowLookup at, bool parallel) {
    vec2 f = fract(at.uv * at.size - 0.5);
    vec2 low = (f - 1.0) / (2.0 - f) - f, high = (1.0 + 2.0 * f) / (1.0 + f) - f;
    vec3 lower = (2.0 - f.x) * glassTap(map, at, low, parallel) +
                 (1.0 + f.x) * glassTap(map, at, vec2(high.x, low.y), parallel);
    vec3 upper = (2.0 - f.x) * glassTap(map, at, vec2(low.x, high.y), parallel) +
                 (1.0 + f.x) * glassTap(map, at, high, parallel);
    return ((2.0 - f.y) * lower + (1.0 + f.y) * upper) * (1.0 / 9.0);
}

#endif
#endif

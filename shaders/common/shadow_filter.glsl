// The share of light that a shadow map lets through around a place of it: one source for the sun's cascades and for the
// atlas of point and spot lights. Both are arrays of reversed depths, 1 nearest to the light.
//
//     SHADOW_HARD   one bilinear comparison
//     (neither)     a tent of 3x3 bilinear comparisons: 4x4 texels
//     SHADOW_SOFT   penumbrae by the distance of what casts them; the map is bound to a sampler that does not compare
#ifndef SHADOW_FILTER_GLSL
#define SHADOW_FILTER_GLSL

#if defined(SHADOW_SOFT)
#define SHADOW_MAP sampler2DArray
#else
#define SHADOW_MAP sampler2DArrayShadow
#endif

struct ShadowLookup {
    vec2 uv;
    float layer;
    float reference;  // depth of the surface
    float size;       // of the map, texels a side
    vec2 slope;       // of the surface's depth, per uv; for SHADOW_SOFT, as what follows
    float softness;   // penumbra's radius in uv, per depth between what casts and the surface
    float limit;      // of that radius, uv
};

#if defined(SHADOW_SOFT)

// Bilinear; the surface's plane gives each texel the depth that it should have.
float compareBilinear(SHADOW_MAP map, ShadowLookup at, vec2 offset) {
    vec2 uv = at.uv + offset;
    vec2 f = fract(uv * at.size - 0.5);
    vec4 depths = textureGather(map, vec3(uv, at.layer));
    vec4 lit = step(depths, vec4(at.reference + dot(at.slope, offset)));
    vec4 weights = vec4((1.0 - f.x) * f.y, f.x * f.y, f.x * (1.0 - f.y), (1.0 - f.x) * (1.0 - f.y));
    return dot(lit, weights);
}

// Point i of n on the unit disk, evenly spread (Vogel 1979, "A better way to construct the sunflower head").
vec2 diskPoint(int i, float n, float turn) {
    float angle = float(i) * 2.399963 + turn;
    return sqrt((float(i) + 0.5) / n) * vec2(cos(angle), sin(angle));
}

// Fernando 2005, "Percentage-Closer Soft Shadows": first how far away what casts is, then as wide a filter.
float filterShadow(SHADOW_MAP map, ShadowLookup at) {
    // Jimenez 2014, "Next Generation Post Processing in Call of Duty": interleaved gradient noise
    float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    float least = 1.5 / at.size;
    float reach = clamp((1.0 - at.reference) * at.softness, least, at.limit);
    float sum = 0.0, count = 0.0;
    for (int i = 0; i < 8; ++i) {
        vec2 offset = diskPoint(i, 8.0, turn) * reach;
        vec4 depths = textureGather(map, vec3(at.uv + offset, at.layer));
        vec4 casts = vec4(1.0) - step(depths, vec4(at.reference + dot(at.slope, offset)));
        sum += dot(depths, casts);
        count += dot(casts, vec4(1.0));
    }
    if (count == 0.0) return 1.0;
    float radius = clamp((sum / count - at.reference) * at.softness, least, at.limit);
    float lit = 0.0;
    for (int i = 0; i < 12; ++i) lit += compareBilinear(map, at, diskPoint(i, 12.0, turn) * radius);
    return lit * (1.0 / 12.0);
}

#elif defined(SHADOW_HARD)

float filterShadow(SHADOW_MAP map, ShadowLookup at) {
    vec2 f = fract(at.uv * at.size - 0.5);
    vec4 lit = textureGather(map, vec3(at.uv, at.layer), at.reference);
    vec2 rows = mix(lit.wx, lit.zy, f.x);
    return mix(rows.x, rows.y, f.y);
}

#else

// Four gathers; the weights of 4x4 texels.
float filterShadow(SHADOW_MAP map, ShadowLookup at) {
    float texelSize = 1.0 / at.size;
    vec2 texel = at.uv * at.size - 0.5;
    vec2 base = floor(texel);
    vec2 f = texel - base;
    vec2 corner = base * texelSize;
    float two = 2.0 * texelSize;
    // Gathers of the 2x2 blocks whose lower left texels are base + (-1|1, -1|1); order: (0,1) (1,1) (1,0) (0,0).
    vec4 g00 = textureGather(map, vec3(corner, at.layer), at.reference);
    vec4 g10 = textureGather(map, vec3(corner + vec2(two, 0.0), at.layer), at.reference);
    vec4 g01 = textureGather(map, vec3(corner + vec2(0.0, two), at.layer), at.reference);
    vec4 g11 = textureGather(map, vec3(corner + vec2(two, two), at.layer), at.reference);
    vec4 wx = vec4(1.0 - f.x, 1.0, 1.0, f.x) * (1.0 / 3.0);
    vec4 wy = vec4(1.0 - f.y, 1.0, 1.0, f.y) * (1.0 / 3.0);
    float row0 = dot(wx, vec4(g00.w, g00.z, g10.w, g10.z));
    float row1 = dot(wx, vec4(g00.x, g00.y, g10.x, g10.y));
    float row2 = dot(wx, vec4(g01.w, g01.z, g11.w, g11.z));
    float row3 = dot(wx, vec4(g01.x, g01.y, g11.x, g11.y));
    return dot(wy, vec4(row0, row1, row2, row3));
}

#endif

// Receivers step off their surface by about the filter's radius, the more the steeper the light grazes (Holbert, "Saying
// Goodbye to Shadow Acne", GDC 2011). In texels.
float shadowOffset(float cosine) {
    return 0.6 + 1.8 * sqrt(max(1.0 - cosine * cosine, 0.0));
}

#endif

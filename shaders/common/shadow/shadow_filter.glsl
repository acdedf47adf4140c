// The share of light that a shadow map lets through around a place of it: one source for the sun's cascades and for the
// atlas of point and spot lights. Both are arrays of reversed depths, 1 nearest to the light, read by gathers.
//
//     SHADOW_HARD   one bilinear comparison
//     (neither)     a tent of 3x3 bilinear comparisons: 4x4 texels
//     SHADOW_SOFT   penumbrae by the distance of what casts them
//
// Each texel is compared with the depth that the surface's own plane has there, so that a surface does not shade itself
// however wide the filter or grazing the light (Isidoro 2006, "Shadow Mapping: GPU-based Tips and Techniques"), and
// nothing has to be moved by more than a fraction of a texel: shadows stay where they are.

struct ShadowLookup {
    vec2 uv;
    float layer;
    float reference;  // depth of the surface
    vec2 slope;       // of its plane's depth, per texel
    float size;       // of the map, texels a side
    float texelSize;  // 1 / size
    float softness;   // SHADOW_SOFT: penumbra's radius in texels, per depth between what casts and the surface
    float limit;      // SHADOW_SOFT: of that radius
};

// 1 for each texel of the block of 2x2 whose lower left one is `corner` from the place's texel; order of textureGather:
// (0,1) (1,1) (1,0) (0,0). `base`: depth of the plane at the place's texel.
vec4 litTexels(sampler2DArray map, ShadowLookup at, vec2 texel, vec2 corner, float base) {
    vec4 depths = textureGather(map, vec3((texel + corner + 1.0) * at.texelSize, at.layer));
    float low = base + dot(at.slope, corner);
    vec4 plane = low + at.slope.x * vec4(0.0, 1.0, 1.0, 0.0) + at.slope.y * vec4(1.0, 1.0, 0.0, 0.0);
    return step(depths, plane);
}

float compareBilinear(sampler2DArray map, ShadowLookup at, vec2 offset) {
    vec2 place = at.uv * at.size - 0.5;
    vec2 texel = floor(place + offset), f = place + offset - texel;
    vec4 lit = litTexels(map, at, texel, vec2(0.0), at.reference + dot(at.slope, texel - place));
    vec2 rows = mix(lit.wx, lit.zy, f.x);
    return mix(rows.x, rows.y, f.y);
}

#if defined(SHADOW_SOFT)

// Point i of n on the unit disk, evenly spread (Vogel 1979, "A better way to construct the sunflower head").
vec2 diskPoint(int i, float n, float turn) {
    float angle = float(i) * 2.399963 + turn;
    return sqrt((float(i) + 0.5) / n) * vec2(cos(angle), sin(angle));
}

// Fernando 2005, "Percentage-Closer Soft Shadows": first how far away what casts is, then as wide a filter.
float filterShadow(sampler2DArray map, ShadowLookup at) {
    // Jimenez 2014, "Next Generation Post Processing in Call of Duty": interleaved gradient noise
    float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    const float least = 1.5;
    float reach = clamp((1.0 - at.reference) * at.softness, least, at.limit);
    float sum = 0.0, count = 0.0;
    for (int i = 0; i < 8; ++i) {
        vec2 offset = diskPoint(i, 8.0, turn) * reach;
        vec4 depths = textureGather(map, vec3(at.uv + offset * at.texelSize, at.layer));
        vec4 casts = vec4(1.0) - step(depths, vec4(at.reference + dot(at.slope, offset) + 0.5 * (abs(at.slope.x) + abs(at.slope.y))));
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

float filterShadow(sampler2DArray map, ShadowLookup at) {
    return compareBilinear(map, at, vec2(0.0));
}

#else

// Four gathers; the weights of 4x4 texels.
float filterShadow(sampler2DArray map, ShadowLookup at) {
    vec2 place = at.uv * at.size - 0.5;
    vec2 texel = floor(place);
    vec2 f = place - texel;
    float base = at.reference - dot(at.slope, f);
    vec4 g00 = litTexels(map, at, texel, vec2(-1.0, -1.0), base);
    vec4 g10 = litTexels(map, at, texel, vec2(1.0, -1.0), base);
    vec4 g01 = litTexels(map, at, texel, vec2(-1.0, 1.0), base);
    vec4 g11 = litTexels(map, at, texel, vec2(1.0, 1.0), base);
    vec4 wx = vec4(1.0 - f.x, 1.0, 1.0, f.x) * (1.0 / 3.0);
    vec4 wy = vec4(1.0 - f.y, 1.0, 1.0, f.y) * (1.0 / 3.0);
    float row0 = dot(wx, vec4(g00.w, g00.z, g10.w, g10.z));
    float row1 = dot(wx, vec4(g00.x, g00.y, g10.x, g10.y));
    float row2 = dot(wx, vec4(g01.w, g01.z, g11.w, g11.z));
    float row3 = dot(wx, vec4(g01.x, g01.y, g11.x, g11.y));
    return dot(wy, vec4(row0, row1, row2, row3));
}

#endif

// What the plane is moved towards the light, in texels of the map: for casters of coarser levels of detail, and for what
// is lost of the plane's steepness.
float shadowSlack(float tangent, float guessed) {
    return (0.5 + guessed) + ((0.2 + 0.5 * guessed) + 0.02 * tangent) * tangent;
}
// No light comes from behind a triangle, whatever the shading normal says; softly, as a curve's triangles are many.
float beforeTriangle(vec4 facing, vec3 towardsLight) {
    return clamp(0.7 + 8.0 * dot(facing.xyz, towardsLight) + facing.w, 0.0, 1.0);
}

// The share of an area light that reaches a surface, from views that stand in its middle: hard or filtered, what hides its
// middle hides it all; soft, the penumbra follows its outline.

/// The outline as the surface sees it: its middle from the surface, and half axes that span a rectangle or an ellipse.
struct AreaSource {
    vec3 center;
    vec3 x;
    vec3 y;
    bool isRound;
    float extent;  // metres from the middle to the farthest point
};

#if defined(SHADOW_SOFT)

const int kAreaBlockers = 24;
const int kAreaSamples = 24;

// Point i of a sequence that fills the unit square evenly (Roberts 2018, "The Unreasonable Effectiveness of
// Quasirandom Sequences"), shifted from pixel to pixel (Jimenez 2014, interleaved gradient noise).
vec2 squarePoint(int i, vec2 shift) { return fract(vec2(0.7548777, 0.5698403) * (float(i) + 0.5) + shift); }
vec2 areaPoint(vec2 u, bool isRound) {
    float angle = 6.2831853 * u.y;
    return isRound ? sqrt(u.x) * vec2(cos(angle), sin(angle)) : 2.0 * u - 1.0;
}

float litAt(ShadowLookup at, vec2 offset) {
    vec2 place = at.uv * at.size - 0.5 + offset;
    vec2 texel = floor(place), f = place - texel;
    vec4 depths = textureGather(shadowAtlas, vec3((texel + 1.0) * at.texelSize, at.layer));
    float low = at.reference + dot(at.slope, offset - f);
    vec4 plane = low + at.slope.x * vec4(0.0, 1.0, 1.0, 0.0) + at.slope.y * vec4(1.0, 1.0, 0.0, 0.0);
    // Beyond the plane's horizon nothing of the plane is hidden, nor hides.
    vec4 lit = step(depths, max(plane, 0.0));
    vec2 rows = mix(lit.wx, lit.zy, f.x);
    return mix(rows.x, rows.y, f.y);
}

// As filterShadow, with the light's outline in place of a disk: what is o from the light's middle is seen past a caster at
// depth d (near / distance) through the map's place that is moved by (o - T o.forward) (d - reference) / near, T being the
// surface's place.
float filterArea(ShadowLookup at, ShadowFace face, AreaSource source) {
    vec2 middle = at.uv - vec2(face.right.w, face.up.w);
    float scale = at.size / face.forward.w;
    vec2 x = (vec2(dot(face.right.xyz, source.x), dot(face.up.xyz, source.x)) - middle * dot(face.forward.xyz, source.x)) * scale;
    vec2 y = (vec2(dot(face.right.xyz, source.y), dot(face.up.xyz, source.y)) - middle * dot(face.forward.xyz, source.y)) * scale;
    float reach = source.isRound ? max(length(x), length(y)) : max(length(x + y), length(x - y));
    const float least = 1.5;
    float widest = min(1.0 - at.reference, at.limit / reach);
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    vec2 shift = vec2(noise, fract(noise * 7.0));
    float sum = 0.0, count = 0.0;
    for (int i = 0; i < kAreaBlockers; ++i) {
        // As if what casts was anywhere from the surface to the light, and towards the outline: penumbrae begin there.
        float height = fract((float(i) + noise) * (1.0 / float(kAreaBlockers)));
        float wide = min(1.0 / mix(1.0 / at.reference, 1.0, height) - at.reference, widest);
        vec2 u = squarePoint(i, shift);
        vec2 q = areaPoint(source.isRound ? vec2(sqrt(u.x), u.y) : u, source.isRound) * wide;
        vec2 offset = x * q.x + y * q.y;
        vec4 depths = textureGather(shadowAtlas, vec3(at.uv + offset * at.texelSize, at.layer));
        float plane = at.reference + dot(at.slope, offset) + 0.5 * (abs(at.slope.x) + abs(at.slope.y));
        // What lies between the surface and the light, not beside the way to it.
        float away = source.isRound ? length(q) : max(abs(q.x), abs(q.y));
        vec4 casts = step(max(vec4(plane), vec4(at.reference + away - least / reach)), depths) * step(1e-9, depths);
        sum += dot(depths, casts);
        count += dot(casts, vec4(1.0));
    }
    if (count == 0.0) return 1.0;
    float depth = clamp(sum / count - at.reference, 0.0, widest);
    x *= max(depth, least / max(length(x), 1e-6));
    y *= max(depth, least / max(length(y), 1e-6));
    float lit = 0.0;
    for (int i = 0; i < kAreaSamples; ++i) {
        vec2 q = areaPoint(squarePoint(i, shift), source.isRound);
        lit += litAt(at, x * q.x + y * q.y);
    }
    return lit * (1.0 / float(kAreaSamples));
}

#endif

// `first`: index of the light's first face.
LampShare areaVisibility(int first, LitSurface s, AreaSource source) {
    vec3 p = -source.center;
    float distance = max(length(p), 1e-4);
    vec3 towards = source.center / distance;
    // The cube may be turned: its faces along +x, +y and +z know how.
    vec3 local = vec3(dot(texelFetch(shadowFaces, first * 4 + 2).xyz, p),
                      dot(texelFetch(shadowFaces, first * 4 + 10).xyz, p),
                      dot(texelFetch(shadowFaces, first * 4 + 18).xyz, p));
    ShadowFace face = shadowFace(first + cubeFace(local));
    float cosine = max(dot(s.facing.xyz, towards), 1.0 / RL_STEEPEST_RECEIVER);
    ShadowLookup at = lookUpFace(face, s, p, distance, cosine);
#if defined(SHADOW_SOFT)
    float lit = filterArea(at, face, source);
#else
    float lit = filterShadow(shadowAtlas, at);
#endif
    // As beforeTriangle, but a part of the light may be before a triangle whose plane its middle is behind.
    float before = dot(s.facing.xyz, towards) + source.extent / distance;
    lit *= clamp(0.7 + 8.0 * before + s.facing.w, 0.0, 1.0);
#if defined(ATLAS_GLASS)
    return lit * filterGlass(atlasGlass, at, false);
#else
    return lit;
#endif
}

// The share of the sun that reaches a point, from the cascades.
layout(binding = RL_TEXTURE_SHADOW) uniform sampler2DArray shadowMap;

// Texels at a cascade's rim that its filter may read beyond the point.
#if defined(SHADOW_SOFT)
#define SHADOW_RIM float(RL_SHADOW_RIM_SOFT)
#else
#define SHADOW_RIM float(RL_SHADOW_RIM)
#endif

/// Of all of a sun's cascades.
struct SunMap {
    vec4 rows[3];
    vec4 settings;
    float softness;
};

SunShare cascadeVisibility(SunMap map, LitSurface s, vec3 towardsLight, vec4 cascade, float layer) {
    vec4 p = vec4(s.position, 1.0);
    float cosine = max(dot(s.facing.xyz, towardsLight), 1.0 / RL_STEEPEST_RECEIVER);
    // The surface's plane: a metre along x its depth falls by n.x / n.l metres, and so for y.
    vec2 tangents = vec2(dot(map.rows[0].xyz, s.facing.xyz), dot(map.rows[1].xyz, s.facing.xyz)) / cosine;
    float depthPerTexel = map.settings.x * cascade.w;
    ShadowLookup at;
    at.uv = vec2(dot(map.rows[0], p), dot(map.rows[1], p)) * cascade.x + cascade.yz;
    at.layer = layer;
    at.slope = tangents * -depthPerTexel;
    at.reference = min(dot(map.rows[2], p) + depthPerTexel * shadowSlack(length(tangents), s.facing.w), 1.0);
    at.size = map.settings.y;
    at.texelSize = map.settings.z;
#if defined(SHADOW_SOFT)
    at.softness = map.softness / cascade.w;
    at.limit = float(RL_SHADOW_RIM_SOFT) - 2.0;
#endif
#if defined(SUN_GLASS)
    return filterShadow(shadowMap, at) * filterGlass(sunGlass, at, true);
#else
    return filterShadow(shadowMap, at);
#endif
}

SunShare sunVisibility(LitSurface s, vec3 towardsLight) {
    vec4 p = vec4(s.position, 1.0);
    vec2 metres = vec2(dot(L_SHADOW_ROW(0), p), dot(L_SHADOW_ROW(1), p));
    // The finest cascade that holds the point with the filter's margin, else the last. In a band along its edge it
    // fades into the next; the second look-up is skipped wherever all pixels of a block are outside of bands.
    float margin = 0.5 - SHADOW_RIM * L_SHADOW_SETTINGS.z;
    vec4 picked = L_SHADOW_CASCADE(SHADOW_CASCADES - 1);
    vec4 next = picked;
    float layer = float(SHADOW_CASCADES - 1);
    float weight = 1.0;
#define TRY_CASCADE(i)                                                      \
    {                                                                       \
        vec4 c = L_SHADOW_CASCADE(i);                                       \
        vec2 d = abs(metres * c.x + c.yz - 0.5);                            \
        float inside = margin - max(d.x, d.y);                              \
        if (inside > 0.0) {                                                 \
            next = L_SHADOW_CASCADE(i + 1);                                 \
            picked = c;                                                     \
            layer = float(i);                                               \
            weight = inside * (1.0 / RL_CASCADE_BAND);                      \
        }                                                                   \
    }
#if SHADOW_CASCADES > 3
    TRY_CASCADE(2)
#endif
#if SHADOW_CASCADES > 2
    TRY_CASCADE(1)
#endif
#if SHADOW_CASCADES > 1
    TRY_CASCADE(0)
#endif
    SunMap map;
    for (int i = 0; i < 3; ++i) map.rows[i] = L_SHADOW_ROW(i);
    map.settings = L_SHADOW_SETTINGS;
#if defined(SHADOW_SOFT)
    map.softness = L_SHADOW_SOFTNESS.x;
#endif
    SunShare lit = cascadeVisibility(map, s, towardsLight, picked, layer);
#if SHADOW_CASCADES > 1
    if (weight < 1.0)
        lit = mix(cascadeVisibility(map, s, towardsLight, next, layer + 1.0), lit, weight);
#endif
    // Beyond the last cascade there is no shadow. One that follows the camera fades out, one that holds the scene ends.
    vec4 last = L_SHADOW_CASCADE(SHADOW_CASCADES - 1);
    vec2 outside = abs(metres * last.x + last.yz - 0.5);
    float fade = (0.5 - max(outside.x, outside.y)) * L_SHADOW_SETTINGS.w;
    return mix(SunShare(1.0), lit, clamp(fade, 0.0, 1.0)) * beforeTriangle(s.facing, towardsLight);
}

// The share of light of the suns after the first that casts: at most two cascades each, in the shadow map's layers after
// the first's. Their constants are where the shadow faces are, before those. Layout: GpuSecondSun in
// renderer/shadows/second_suns.h.

// `sun` counts from 0.
SunShare secondSunVisibility(int sun, LitSurface s, vec3 towardsLight) {
    int texel = sun * 8;
    SunMap map;
    for (int i = 0; i < 3; ++i) map.rows[i] = texelFetch(shadowFaces, texel + i);
    map.settings = texelFetch(shadowFaces, texel + 3);
    map.softness = texelFetch(shadowFaces, texel + 4).x;
    vec4 p = vec4(s.position, 1.0);
    vec2 metres = vec2(dot(map.rows[0], p), dot(map.rows[1], p));
    float layer = float(SHADOW_CASCADES + sun * SECOND_CASCADES + SECOND_CASCADES - 1);
    vec4 last = texelFetch(shadowFaces, texel + 4 + SECOND_CASCADES);
    SunShare lit = cascadeVisibility(map, s, towardsLight, last, layer);
#if SECOND_CASCADES > 1
    vec4 first = texelFetch(shadowFaces, texel + 5);
    vec2 d = abs(metres * first.x + first.yz - 0.5);
    float inside = 0.5 - SHADOW_RIM * map.settings.z - max(d.x, d.y);
    if (inside > 0.0)
        lit = mix(lit, cascadeVisibility(map, s, towardsLight, first, layer - 1.0),
                  min(inside * (1.0 / RL_CASCADE_BAND), 1.0));
#endif
    vec2 outside = abs(metres * last.x + last.yz - 0.5);
    float fade = (0.5 - max(outside.x, outside.y)) * map.settings.w;
    return mix(SunShare(1.0), lit, clamp(fade, 0.0, 1.0)) * beforeTriangle(s.facing, towardsLight);
}

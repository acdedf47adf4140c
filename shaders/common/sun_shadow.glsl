// The share of the sun that reaches a point, from the cascades.
layout(binding = RL_TEXTURE_SHADOW) uniform sampler2DArrayShadow shadowMap;

// A 3x3 tent of bilinear comparisons from four gathers: the weights of 4x4 texels.
float filterShadow(vec2 uv, float layer, float reference) {
    vec2 texel = uv * L_SHADOW_SETTINGS.y - 0.5;
    vec2 base = floor(texel);
    vec2 f = texel - base;
    vec2 corner = base * L_SHADOW_SETTINGS.z;
    float two = 2.0 * L_SHADOW_SETTINGS.z;
    // Gathers of the 2x2 blocks whose lower left texels are base + (-1|1, -1|1); order: (0,1) (1,1) (1,0) (0,0).
    vec4 g00 = textureGather(shadowMap, vec3(corner, layer), reference);
    vec4 g10 = textureGather(shadowMap, vec3(corner + vec2(two, 0.0), layer), reference);
    vec4 g01 = textureGather(shadowMap, vec3(corner + vec2(0.0, two), layer), reference);
    vec4 g11 = textureGather(shadowMap, vec3(corner + vec2(two, two), layer), reference);
    vec4 wx = vec4(1.0 - f.x, 1.0, 1.0, f.x) * (1.0 / 3.0);
    vec4 wy = vec4(1.0 - f.y, 1.0, 1.0, f.y) * (1.0 / 3.0);
    float row0 = dot(wx, vec4(g00.w, g00.z, g10.w, g10.z));
    float row1 = dot(wx, vec4(g00.x, g00.y, g10.x, g10.y));
    float row2 = dot(wx, vec4(g01.w, g01.z, g11.w, g11.z));
    float row3 = dot(wx, vec4(g01.x, g01.y, g11.x, g11.y));
    return dot(wy, vec4(row0, row1, row2, row3));
}

vec4 pickCascade(vec2 metres, out float layer) {
    // The finest cascade that holds the point with the filter's margin, else the last.
    float margin = 0.5 - 3.0 * L_SHADOW_SETTINGS.z;
    vec4 picked = L_SHADOW_CASCADE(SHADOW_CASCADES - 1);
    layer = float(SHADOW_CASCADES - 1);
#if SHADOW_CASCADES > 3
    {
        vec4 c = L_SHADOW_CASCADE(2);
        vec2 d = abs(metres * c.x + c.yz - 0.5);
        if (max(d.x, d.y) < margin) { picked = c; layer = 2.0; }
    }
#endif
#if SHADOW_CASCADES > 2
    {
        vec4 c = L_SHADOW_CASCADE(1);
        vec2 d = abs(metres * c.x + c.yz - 0.5);
        if (max(d.x, d.y) < margin) { picked = c; layer = 1.0; }
    }
#endif
#if SHADOW_CASCADES > 1
    {
        vec4 c = L_SHADOW_CASCADE(0);
        vec2 d = abs(metres * c.x + c.yz - 0.5);
        if (max(d.x, d.y) < margin) { picked = c; layer = 0.0; }
    }
#endif
    return picked;
}

float sunVisibility(LitSurface s, vec3 towardsLight) {
    vec4 p = vec4(s.position, 1.0);
    vec2 metres = vec2(dot(L_SHADOW_ROW(0), p), dot(L_SHADOW_ROW(1), p));
    float layer;
    vec4 cascade = pickCascade(metres, layer);
    // Receivers step off their surface by about the filter's radius, the more the steeper the light grazes
    // (Holbert, "Saying Goodbye to Shadow Acne", GDC 2011).
    float cosine = clamp(dot(s.point.normal, towardsLight), 0.0, 1.0);
    float sine = sqrt(1.0 - cosine * cosine);
    vec4 q = vec4(s.position + s.point.normal * (cascade.w * (0.6 + 1.8 * sine)), 1.0);
    vec2 uv = vec2(dot(L_SHADOW_ROW(0), q), dot(L_SHADOW_ROW(1), q)) * cascade.x + cascade.yz;
    float reference = dot(L_SHADOW_ROW(2), q);
    float lit = filterShadow(uv, layer, min(reference, 1.0));
    // Beyond the last cascade there is no shadow.
    vec2 outside = abs(uv - 0.5);
    return max(outside.x, outside.y) < 0.5 ? lit : 1.0;
}

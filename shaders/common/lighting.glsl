// Direct light of suns and clustered lights, shadows, and the ambient term: one source for deferred and forward.
// Constants come from the block `L_...` reads, or, with LIGHTING_VARYINGS, from flat varyings that the full-screen
// vertex shader copied: llvmpipe reads those three times as fast.
#include "interop/bindings.h"
#include "interop/brdf.h"
#include "interop/frame_uniforms.h"

#if defined(SUN_SHADOW)
layout(binding = RL_TEXTURE_SHADOW) uniform sampler2DArrayShadow shadowMap;
#endif
#if defined(CLUSTERED_LIGHTS)
layout(binding = RL_TEXTURE_LIGHTS) uniform samplerBuffer lightTexels;
layout(binding = RL_TEXTURE_CLUSTERS) uniform usamplerBuffer clusterTexels;
layout(binding = RL_TEXTURE_LIGHT_INDICES) uniform usamplerBuffer lightIndexTexels;
#endif
#if defined(ENVIRONMENT)
layout(binding = RL_TEXTURE_ENVIRONMENT) uniform samplerCube environmentMap;
layout(binding = RL_TEXTURE_IRRADIANCE) uniform samplerCube irradianceMap;
layout(binding = RL_TEXTURE_BRDF_TABLE) uniform sampler2D brdfTable;
#endif

struct LitSurface {
    vec3 position;  // relative to the camera, world axes
    float viewDepth;
    vec3 baseColor;
    float metallic;
    float roughness;
    float occlusion;
    ShadingPoint point;
};

LitSurface makeLitSurface(vec3 position, float viewDepth, vec3 view, vec3 normal, vec3 baseColor,
                          float metallic, float roughness, float occlusion) {
    LitSurface s;
    s.position = position;
    s.viewDepth = viewDepth;
    s.baseColor = baseColor;
    s.metallic = metallic;
    s.roughness = roughness;
    s.occlusion = occlusion;
    s.point = makeShadingPoint(baseColor, metallic, roughness, normal, view);
    return s;
}

#if defined(SUN_SHADOW)
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
#endif

vec3 directionalLight(LitSurface s) {
    vec3 sum = vec3(0.0);
#if DIRECTIONAL_LIGHTS > 0
    {
        vec3 l = L_DIRECTION(0).xyz;
        vec3 light = evaluateBrdf(s.point, l) * L_ILLUMINANCE(0).rgb;
#if defined(SUN_SHADOW)
        light *= sunVisibility(s, l);
#endif
        sum += light;
    }
#endif
#if DIRECTIONAL_LIGHTS > 1
    sum += evaluateBrdf(s.point, L_DIRECTION(1).xyz) * L_ILLUMINANCE(1).rgb;
#endif
#if DIRECTIONAL_LIGHTS > 2
    sum += evaluateBrdf(s.point, L_DIRECTION(2).xyz) * L_ILLUMINANCE(2).rgb;
#endif
#if DIRECTIONAL_LIGHTS > 3
    sum += evaluateBrdf(s.point, L_DIRECTION(3).xyz) * L_ILLUMINANCE(3).rgb;
#endif
    return sum;
}

#if defined(CLUSTERED_LIGHTS)
int clusterAt(vec2 pixel, float viewDepth) {
    float slice = floor(log2(max(viewDepth, 1e-6)) * L_CLUSTER_MAPPING.x + L_CLUSTER_MAPPING.y);
    slice = clamp(slice, 0.0, L_CLUSTER_COUNTS.z - 1.0);
    vec2 tile = floor(pixel * (1.0 / float(RL_CLUSTER_PIXELS)));
    return int(slice * L_CLUSTER_MAPPING.w + tile.y * L_CLUSTER_MAPPING.z + tile.x);
}

vec3 clusteredLight(LitSurface s, vec2 pixel) {
    uint cluster = texelFetch(clusterTexels, clusterAt(pixel, s.viewDepth)).x;
    int first = int(cluster >> 10);
    int count = int(cluster & 1023u);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < count; ++i) {
        int light = int(texelFetch(lightIndexTexels, first + i).x) * 3;
        vec4 a = texelFetch(lightTexels, light);
        vec4 b = texelFetch(lightTexels, light + 1);
        vec4 c = texelFetch(lightTexels, light + 2);
        vec3 to = a.xyz - s.position;
        float distanceSquared = dot(to, to);
        vec3 l = to * inversesqrt(max(distanceSquared, 1e-8));
        float attenuation = distanceAttenuation(distanceSquared, a.w) *
                            spotAttenuation(-dot(l, c.xyz), vec2(b.w, c.w));
        sum += evaluateBrdf(s.point, l) * b.rgb * attenuation;
    }
    return sum;
}
#endif

vec3 ambientLight(LitSurface s) {
    vec3 n = s.point.normal;
    vec3 albedo = s.baseColor * (1.0 - s.metallic);
#if defined(ENVIRONMENT)
    vec3 r = reflect(-s.point.view, n);
    vec2 turn = L_ENVIRONMENT.xy;
    vec3 nt = vec3(turn.x * n.x - turn.y * n.z, n.y, turn.y * n.x + turn.x * n.z);
    vec3 rt = vec3(turn.x * r.x - turn.y * r.z, r.y, turn.y * r.x + turn.x * r.z);
    vec2 table = textureLod(brdfTable, vec2(s.point.nDotV, clampRoughness(s.roughness)), 0.0).xy;
    EnvironmentWeights w = environmentWeights(albedo, s.point.f0, table);
    vec3 specular =
        textureLod(environmentMap, rt, environmentLevel(s.roughness, L_ENVIRONMENT.w)).rgb;
    vec3 irradiance = textureLod(irradianceMap, nt, 0.0).rgb;
    vec3 light = w.diffuse * irradiance + w.specular * specular;
    return light * (L_ENVIRONMENT.z * s.occlusion);
#elif defined(HEMISPHERE)
    // The specular lobe of a hemisphere, without a table: Karis 2014, "Physically Based Shading on Mobile".
    vec4 k = s.roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(k.x * k.x, exp2(-9.28 * s.point.nDotV)) * k.x + k.y;
    vec2 table = vec2(-1.04, 1.04) * a + k.zw;
    vec3 r = reflect(-s.point.view, n);
    vec3 diffuse = mix(L_AMBIENT_GROUND.rgb, L_AMBIENT_SKY.rgb, n.y * 0.5 + 0.5);
    vec3 specular = mix(L_AMBIENT_GROUND.rgb, L_AMBIENT_SKY.rgb, r.y * 0.5 + 0.5);
    return (albedo * diffuse + specularAlbedo(s.point.f0, table) * specular) * s.occlusion;
#else
    return vec3(0.0);
#endif
}

vec3 lightSurface(LitSurface s, vec2 pixel) {
    vec3 radiance = directionalLight(s) + ambientLight(s);
#if defined(CLUSTERED_LIGHTS)
    radiance += clusteredLight(s, pixel);
#endif
    return radiance;
}

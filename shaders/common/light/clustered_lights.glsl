// Lights from the lists of the pixel's froxel (renderer/lighting/clusters/light_clusters.h). Lists are sorted by class, and each class
// has a loop of its own, so that a light costs what it needs: on llvmpipe a branch within a loop saves nothing.
layout(binding = RL_TEXTURE_LIGHTS) uniform samplerBuffer lightTexels;
layout(binding = RL_TEXTURE_CLUSTERS) uniform usamplerBuffer clusterTexels;
layout(binding = RL_TEXTURE_LIGHT_INDICES) uniform usamplerBuffer lightIndexTexels;

#if defined(MODULATED_LIGHTS) || defined(AREA_LIGHTS)
#define CLUSTER_WORDS 2
#else
#define CLUSTER_WORDS 1
#endif

#if defined(AREA_LIGHTS)
#include "common/light/area_lights.glsl"
#endif

int clusterAt(vec2 pixel, float viewDepth) {
    float slice = floor(log2(max(viewDepth, 1e-6)) * L_CLUSTER_MAPPING.x + L_CLUSTER_MAPPING.y);
    slice = clamp(slice, 0.0, L_CLUSTER_COUNTS.z - 1.0);
    vec2 tile = floor(pixel * L_CLUSTER_COUNTS.w);
    return int(slice * L_CLUSTER_MAPPING.w + tile.y * L_CLUSTER_MAPPING.z + tile.x);
}

/// All the lights of a froxel
int lightCount(int cluster) {
    int count = int(texelFetch(clusterTexels, cluster * CLUSTER_WORDS).x & 1023u);
#if CLUSTER_WORDS > 1
    uint others = texelFetch(clusterTexels, cluster * CLUSTER_WORDS + 1).x;
    count += int((others & 1023u) + (others >> 10));
#endif
    return count;
}

/// One light at a surface that nothing hides: intensity times attenuation lights a surface that faces it.
struct LightSample {
    int texel;  // of its first slot
    vec3 direction;
    float distanceSquared;
    vec3 intensity;
    float attenuation;
};

LightSample sampleLight(int listed, LitSurface s) {
    LightSample r;
    r.texel = int(texelFetch(lightIndexTexels, listed).x) * 3;
    vec4 a = texelFetch(lightTexels, r.texel);
    vec4 b = texelFetch(lightTexels, r.texel + 1);
    vec4 c = texelFetch(lightTexels, r.texel + 2);
    vec3 to = a.xyz - s.position;
    r.distanceSquared = dot(to, to);
    r.direction = to * inversesqrt(max(r.distanceSquared, 1e-8));
    r.intensity = b.rgb;
    r.attenuation = distanceAttenuation(r.distanceSquared, a.w) *
                    spotAttenuation(-dot(r.direction, c.xyz), vec2(b.w, c.w));
    return r;
}

#if defined(LIGHT_PATTERNS)
#include "common/light/light_patterns.glsl"
#endif

void shadowLight(inout LightSample light, float share) { light.attenuation *= share; }
void shadowLight(inout LightSample light, vec3 share) { light.intensity *= share; }

vec3 clusteredLight(LitSurface s, vec2 pixel) {
#if defined(LIGHT_PATTERNS)
    float footprint = sqrt(length(cross(dFdx(s.position), dFdy(s.position))));
#endif
    int cluster = clusterAt(pixel, s.viewDepth);
    uint record = texelFetch(clusterTexels, cluster * CLUSTER_WORDS).x;
    int first = int(record >> 10);
    int count = int(record & 1023u);
    vec3 sum = vec3(0.0);
#if defined(PLAIN_LIGHTS)
    for (int i = 0; i < count; ++i) {
        LightSample light = sampleLight(first + i, s);
        sum += evaluateBrdf(s.point, light.direction) * light.intensity * light.attenuation;
    }
#endif
#if CLUSTER_WORDS > 1
    uint others = texelFetch(clusterTexels, cluster * CLUSTER_WORDS + 1).x;
    first += count;
    count = int(others & 1023u);
#endif
#if defined(MODULATED_LIGHTS)
#if defined(LIGHT_CONTACT)
    ContactScreen screen = contactScreen();
#endif
    for (int i = 0; i < count; ++i) {
        LightSample light = sampleLight(first + i, s);
        // x: shadow record, y: the source's radius, zw: profile and cookie
        vec4 modulation = texelFetch(lightTexels, light.texel + 3);
#if defined(PUNCTUAL_SHADOW)
        if (modulation.x >= 0.0) {
            float distance = sqrt(light.distanceSquared);
            shadowLight(light, punctualVisibility(int(modulation.x), s, light.direction, distance));
#if defined(LIGHT_CONTACT)
            // not as far as the light itself: what it stands in casts nothing
            float reach = min(L_CONTACT_LENGTH, 0.8 * distance);
            shadowLight(light, contactVisibility(s, screen, light.direction, reach));
#endif
        }
#endif
#if defined(LIGHT_PATTERNS)
        light.intensity *= lightPattern(light, modulation, footprint);
#endif
        sum += evaluateBrdf(s.point, light.direction) * light.intensity * light.attenuation;
    }
#endif
#if defined(AREA_LIGHTS)
    first += count;
    count = int(others >> 10);
    AreaFrame frame = makeAreaFrame(s);
    for (int i = 0; i < count; ++i)
        sum += areaLight(int(texelFetch(lightIndexTexels, first + i).x) * 3, s, frame);
#endif
    return sum;
}

// One intermediate image as a picture, chosen by SHOW_...; black where there is no surface.
#define L_CLUSTER_MAPPING flatSettings
#define L_CLUSTER_COUNTS flatCounts
#if defined(SHOW_CLUSTERS)
#define CLUSTERED_LIGHTS
#endif
#include "common/fullscreen.glsl"
#include "common/surface/gbuffer.glsl"
#include "common/screen/occlusion_texel.glsl"
#include "interop/tonemap.h"
#if defined(SHOW_CLUSTERS)
#include "common/light/lighting.glsl"
#elif defined(SHOW_AMBIENT_OCCLUSION)
#include "common/screen/ambient_occlusion.glsl"
#endif

#if defined(SHOW_SHADOW)
// samplers that do not compare
layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2DArray shadowDepths;
layout(binding = RL_TEXTURE_SOURCE1) uniform sampler2DArray atlasDepths;
#elif defined(SHOW_OVERDRAW)
layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2D fragmentCounts;
#else
layout(binding = RL_TEXTURE_GBUFFER0) uniform sampler2D gbuffer0;
layout(binding = RL_TEXTURE_GBUFFER1) uniform sampler2D gbuffer1;
layout(binding = RL_TEXTURE_GBUFFER2) uniform sampler2D gbuffer2;
layout(binding = RL_TEXTURE_DEPTH) uniform sampler2D depthMap;
#endif

layout(location = 0) out vec4 display;

float viewDepthOf(float depth) {
    float linear = depth * flatSourceTexel.z + flatSourceTexel.w;
#if defined(ORTHOGRAPHIC)
    return linear;
#else
    return 1.0 / linear;
#endif
}

// Black, blue, green, yellow, red, white
vec3 falseColor(float t) {
    float x = clamp(t, 0.0, 1.0) * 5.0;
    return clamp(vec3(x - 2.0, 1.0 - abs(x - 2.5) * 0.5 + 0.25, min(x, 3.0 - x)), 0.0, 1.0) +
           clamp(x - 4.0, 0.0, 1.0) * vec3(0.0, 1.0, 1.0);
}

#if defined(SHOW_SHADOW)
vec3 shownColor(float surface) {
    float place = uv.x * flatCounts.x;
    float layer = min(floor(place), flatCounts.x - 1.0);
    vec2 at = vec2(place - layer, uv.y) - 0.5;
    at = flatSettings.x < 1.0 ? vec2(at.x, at.y / flatSettings.x) : vec2(at.x * flatSettings.x, at.y);
    float inside = max(abs(at.x), abs(at.y)) < 0.5 ? 1.0 : 0.0;
    // Perspective depths are small: their fourth root tells them apart.
    float depth = layer < flatCounts.y
                      ? textureLod(shadowDepths, vec3(at + 0.5, layer), 0.0).x
                      : sqrt(sqrt(textureLod(atlasDepths, vec3(at + 0.5, 0.0), 0.0).x));
    return vec3(depth * inside);
}
#elif defined(SHOW_OVERDRAW)
vec3 shownColor(float surface) {
    return falseColor(textureLod(fragmentCounts, uv, 0.0).x * (1.0 / 8.0));
}
#else
vec3 shownColor(float depth) {
#if defined(SHOW_AMBIENT_OCCLUSION)
    vec3 normal = unpackNormal(textureLod(gbuffer1, uv, 0.0).rgb);
    float perDepth = abs(flatSourceTexel.z);
#if !defined(ORTHOGRAPHIC)
    perDepth *= viewDepthOf(depth);
#endif
    return vec3(ambientVisibility(uv / flatSourceTexel.xy, depth, perDepth, normal).visible);
#else
    GBufferSample g = decodeGBuffer(GBufferTexels(textureLod(gbuffer0, uv, 0.0),
                                                  textureLod(gbuffer1, uv, 0.0),
                                                  textureLod(gbuffer2, uv, 0.0)));
#if defined(SHOW_BASE_COLOR)
    return encodeSrgb(g.baseColor);
#elif defined(SHOW_METALLIC)
    return vec3(g.metallic);
#elif defined(SHOW_ROUGHNESS)
    return vec3(g.roughness);
#elif defined(SHOW_NORMAL)
    return g.normal * 0.5 + 0.5;
#elif defined(SHOW_EMISSIVE)
    return encodeSrgb(toneMapNeutral(g.emissive));
#elif defined(SHOW_OCCLUSION)
    return vec3(g.occlusion);
#elif defined(SHOW_VELOCITY)
    // Grey is rest; red to the right, green up; the root shows slow motion too.
    vec2 v = g.velocity;
    return vec3(0.5 + 0.5 * sign(v) * sqrt(abs(v)), 0.5);
#elif defined(SHOW_DEPTH)
    // White is near; by the logarithm, as eyes judge distance.
    float span = log2(flatSettings.y / flatSettings.x);
    return vec3(clamp(1.0 - log2(viewDepthOf(depth) / flatSettings.x) / span, 0.0, 1.0));
#elif defined(SHOW_CLUSTERS)
    int count = lightCount(clusterAt(uv / flatSourceTexel.xy, viewDepthOf(depth)));
    return falseColor(float(count) * (1.0 / 32.0));
#else
    return vec3(0.0);  // SHOW_NOTHING: what is asked for is not in this frame
#endif
#endif
}
#endif

void main() {
#if defined(SHOW_SHADOW) || defined(SHOW_OVERDRAW)
    display = vec4(shownColor(0.0), 1.0);
#else
    float depth = textureLod(depthMap, uv, 0.0).x;
    vec3 color = shownColor(max(depth, 1e-7));
    display = vec4(depth > 0.0 ? color : vec3(0.0), 1.0);
#endif
}

// Full size: where a reflection was hit it takes the place of what lighting added for the surroundings. Added to the lit
// radiance; the difference may be negative, the sum is not. SHOW_REFLECTIONS: the reflections alone.
#include "common/surface/gbuffer.glsl"
#include "common/light/lighting_varyings.glsl"
#include "common/surface/lit_surface.glsl"
#include "common/screen/occlusion_texel.glsl"
#include "common/light/ambient_specular.glsl"
#if defined(AMBIENT_OCCLUSION)
#include "common/screen/ambient_occlusion.glsl"
#endif
#if defined(IRRADIANCE_VOLUME)
#include "common/light/local_light.glsl"
#endif

layout(binding = RL_TEXTURE_GBUFFER0) uniform sampler2D gbuffer0;
layout(binding = RL_TEXTURE_GBUFFER1) uniform sampler2D gbuffer1;
layout(binding = RL_TEXTURE_GBUFFER2) uniform sampler2D gbuffer2;
layout(binding = RL_TEXTURE_DEPTH) uniform sampler2D depthMap;
layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2D reflectionMap;

layout(location = 0) out vec4 radiance;

// rgb: radiance times confidence; a: confidence. Of the up to four texels about the pixel, those of its surface; texel
// (x, y) was made at pixel (2x, 2y).
vec4 reflectionAt(ivec2 pixel, float depth, float perDepth) {
    ivec2 low = pixel / 2;
    ivec2 high = min(low + pixel - low * 2, textureSize(reflectionMap, 0) - 1);
    vec4 sum = vec4(0.0);
    float total = 1e-6;
    for (int i = 0; i < 4; ++i) {
        ivec2 at = ivec2((i & 1) == 0 ? low.x : high.x, (i & 2) == 0 ? low.y : high.y);
        vec4 texel = texelFetch(reflectionMap, at, 0);
        float weight = texel.w > 0.0 ? 1.0 / (0.002 + abs(texel.w - depth) * perDepth) : 0.0;
        float sure = occlusionVisible(texel.w);
        sum += vec4(texel.rgb * sure, sure) * weight;
        total += weight;
    }
    return sum / total;
}

void main() {
    float depth = textureLod(depthMap, screenUv, 0.0).x;
    float linear = depth * flatDepthDecode.x + flatDepthDecode.y;
#if defined(ORTHOGRAPHIC)
    float viewDepth = linear;
    vec3 view = -flatViewDirection.xyz;
    float perDepth = abs(flatDepthDecode.x);
#else
    float viewDepth = 1.0 / linear;
    vec3 view = -normalize(pixelRay);
    float perDepth = abs(flatDepthDecode.x) * viewDepth;
#endif
    vec4 hit = reflectionAt(ivec2(gl_FragCoord.xy), depth, perDepth);
    if (hit.a <= 0.0) discard;  // llvmpipe leaves here where no pixel of a block goes on; it would not for a return
    GBufferSample g = decodeGBuffer(GBufferTexels(textureLod(gbuffer0, screenUv, 0.0),
                                                  textureLod(gbuffer1, screenUv, 0.0),
                                                  textureLod(gbuffer2, screenUv, 0.0)));
    LitSurface s = makeLitSurface(pixelBase + pixelRay * viewDepth, viewDepth, view, g.normal,
                                  g.baseColor, g.metallic, g.roughness, g.occlusion);
#if defined(AMBIENT_OCCLUSION)
    AmbientVisibility ambient = ambientVisibility(gl_FragCoord.xy, depth, perDepth, g.normal);
    s.visible = ambient.visible;
    s.bent = ambient.bent;
#endif
#if defined(IRRADIANCE_VOLUME)
    localLight(gl_FragCoord.xy, viewDepth, s.tint, s.flow);
#endif
#if defined(REFLECTION_PROBES)
    gatherReflectionProbes(s);
#endif
    EnvironmentWeights weights = ambientWeights(s);
    vec3 mirrored = weights.specular * hit.rgb;
#if !defined(SHOW_REFLECTIONS)
    mirrored -= ambientSpecular(s, weights) * hit.a;
#endif
    radiance = vec4(mirrored * (1.0 - g.unlit), 0.0);
}

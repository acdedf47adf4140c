#include "common/surface/gbuffer.glsl"
#include "common/light/lighting_varyings.glsl"

layout(binding = RL_TEXTURE_DEPTH) uniform sampler2D depthMap;

#if defined(AMBIENT_OCCLUSION)
#include "interop/occlusion_arc.h"  // before ambient light includes it: the image may be looked at where there is none
#endif
#include "common/light/lighting.glsl"
#if defined(LIGHTING_PART)
#include "common/light/lighting_parts.glsl"
#endif
#if defined(AMBIENT_OCCLUSION)
#include "common/screen/ambient_occlusion.glsl"
#endif

#if defined(IRRADIANCE_VOLUME)
#include "common/light/local_light.glsl"
#endif

layout(binding = RL_TEXTURE_GBUFFER0) uniform sampler2D gbuffer0;
layout(binding = RL_TEXTURE_GBUFFER1) uniform sampler2D gbuffer1;
layout(binding = RL_TEXTURE_GBUFFER2) uniform sampler2D gbuffer2;

layout(location = 0) out vec4 radiance;

#if defined(SUN_SHADOW) || defined(PUNCTUAL_SHADOW) || defined(AREA_SHADOW)
#include "common/surface/facing_depths.glsl"
#endif

void main() {
    GBufferSample g = decodeGBuffer(GBufferTexels(textureLod(gbuffer0, screenUv, 0.0),
                                                  textureLod(gbuffer1, screenUv, 0.0),
                                                  textureLod(gbuffer2, screenUv, 0.0)));
#if defined(PART_UNTEXTURED)
    g.baseColor = vec3(1.0);
    g.metallic = 0.0;
#endif
    float depth = textureLod(depthMap, screenUv, 0.0).x;
    float linear = depth * flatDepthDecode.x + flatDepthDecode.y;
#if defined(ORTHOGRAPHIC)
    float viewDepth = linear;
    vec3 view = -flatViewDirection.xyz;
#else
    float viewDepth = 1.0 / linear;
    vec3 view = -normalize(pixelRay);
#endif
    vec3 position = pixelBase + pixelRay * viewDepth;
    LitSurface s = makeLitSurface(position, viewDepth, view, g.normal, g.baseColor, g.metallic,
                                  g.roughness, g.occlusion);
#if defined(SUN_SHADOW) || defined(PUNCTUAL_SHADOW) || defined(AREA_SHADOW)
    s.facing = facingOfDepths(position, depth, g.normal);
#endif
#if defined(AMBIENT_OCCLUSION)
#if defined(ORTHOGRAPHIC)
    float perDepth = flatDepthDecode.x;
#else
    float perDepth = flatDepthDecode.x * viewDepth;
#endif
    AmbientVisibility ambient =
        ambientVisibility(gl_FragCoord.xy, depth, abs(perDepth), g.normal);
    s.visible = ambient.visible;
    s.bent = ambient.bent;
#endif
#if defined(IRRADIANCE_VOLUME)
    localLight(gl_FragCoord.xy, viewDepth, s.tint, s.flow);
#endif
#if defined(LIGHTING_PART)
    vec3 part = lightingPart(s, gl_FragCoord.xy, g.emissive, g.unlit > 0.5);
    radiance = vec4(min(part, RL_MAX_RADIANCE), 1.0);
#else
    vec3 lit = lightSurface(s, gl_FragCoord.xy) + g.emissive;
    radiance = vec4(min(g.unlit > 0.5 ? g.baseColor : lit, RL_MAX_RADIANCE), 1.0);
#endif
}

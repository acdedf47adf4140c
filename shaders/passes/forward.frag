// What the G-buffer cannot hold: blended surfaces, and (EMISSION_ONLY) the light that moving surfaces give off.
#include "common/material.glsl"
#include "common/lighting_block.glsl"
#include "common/lighting.glsl"
#if defined(FOG)
#define FOG_LOOKUP
#include "common/fog.glsl"
#endif

#if defined(IRRADIANCE_VOLUME)
#include "common/irradiance_probes.glsl"
#endif

layout(std140, binding = RL_UNIFORMS_VIEW) uniform ViewBlock { ViewUniforms view; };

#if defined(DECALS)
#include "common/decals.glsl"
#endif

layout(location = 0) out vec4 radiance;  // premultiplied

/// Light of a surface behind the fog before it.
vec3 behindFog(vec3 light) {
#if defined(FOG)
    float viewDepth = dot(surfacePosition, view.cameraForward.xyz);
    bool perspective = view.cameraPosition.w > 0.5;
    vec3 ray = perspective ? surfacePosition / viewDepth : view.cameraForward.xyz;
    vec3 base = perspective ? vec3(0.0) : surfacePosition - ray * viewDepth;
    vec4 fog = fogAt(gl_FragCoord.xy, base, ray, viewDepth);
#if defined(EMISSION_ONLY)
    return light * (1.0 - fog.a);  // added to what the fog has covered already
#else
    return light * (1.0 - fog.a) + fog.rgb;
#endif
#else
    return light;
#endif
}

void main() {
    SurfaceSample g = sampleSurface();
#if defined(EMISSION_ONLY)
    radiance = vec4(behindFog(g.emissive), 0.0);
#elif defined(UNLIT)
    radiance = vec4(behindFog(g.baseColor.rgb) * g.baseColor.a, g.baseColor.a);
#else
#if defined(DECALS)
    applyDecals(surfacePosition, gl_FragCoord.xy, g.baseColor.rgb, g.normal, g.roughness,
                g.metallic);
#endif
    vec3 towardsEye = view.cameraPosition.w > 0.5 ? -normalize(surfacePosition)
                                                  : -view.cameraForward.xyz;
    float viewDepth = dot(surfacePosition, view.cameraForward.xyz);
    LitSurface s = makeLitSurface(surfacePosition, viewDepth, towardsEye, g.normal,
                                  g.baseColor.rgb, g.metallic, g.roughness, g.occlusion);
#if defined(IRRADIANCE_VOLUME)
    shareableLight(lightAround(surfacePosition, g.normal), g.normal, s.tint, s.flow);
#endif
    vec3 lit = lightSurface(s, gl_FragCoord.xy) + g.emissive;
    radiance = vec4(min(behindFog(lit), RL_MAX_RADIANCE) * g.baseColor.a, g.baseColor.a);
#endif
}

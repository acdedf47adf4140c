// What the G-buffer cannot hold: blended surfaces, and (EMISSION_ONLY) the light that moving surfaces give off.
#include "common/surface/material.glsl"
#include "common/light/lighting_block.glsl"
#include "common/light/lighting.glsl"
#if defined(FOG)
#define FOG_LOOKUP
#include "common/screen/fog.glsl"
#endif

#if defined(IRRADIANCE_VOLUME)
#include "common/light/irradiance_probes.glsl"
#endif

layout(std140, binding = RL_UNIFORMS_VIEW) uniform ViewBlock { ViewUniforms view; };

#if defined(DECALS)
#include "common/surface/decals.glsl"
#endif

#if defined(TRANSMISSION)
layout(location = 0, index = 0) out vec4 radiance;
layout(location = 0, index = 1) out vec4 passing;  // BlendMode::filtered: what is seen of what is behind
#else
layout(location = 0) out vec4 radiance;  // premultiplied
#endif

/// Light of a surface behind the fog before it, which is added in front of what the surface covers.
vec3 behindFog(vec3 light, vec3 covers) {
#if defined(FOG)
    float viewDepth = dot(surfacePosition, view.cameraForward.xyz);
    bool perspective = view.cameraPosition.w > 0.5;
    vec3 ray = perspective ? surfacePosition / viewDepth : view.cameraForward.xyz;
    vec3 base = perspective ? vec3(0.0) : surfacePosition - ray * viewDepth;
    vec4 fog = fogAt(gl_FragCoord.xy, base, ray, viewDepth);
#if defined(EMISSION_ONLY)
    return light * (1.0 - fog.a);  // added to what the fog has covered already
#else
    return light * (1.0 - fog.a) + fog.rgb * covers;
#endif
#else
    return light;
#endif
}
vec3 behindFog(vec3 light) { return behindFog(light, vec3(1.0)); }

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
#if defined(TRANSMISSION)
    // What the specular lobe leaves goes through or is scattered back.
    vec3 through = s.point.diffuseOverPi * g.transmission.color * (g.transmission.share / kInversePi);
    s.point.diffuseOverPi *= 1.0 - g.transmission.share;
    s.baseColor *= 1.0 - g.transmission.share;
    float coverage = g.transmission.coverage;
    through = clamp(mix(vec3(1.0), through, coverage), 0.0, 1.0);
    vec3 lit = (lightSurface(s, gl_FragCoord.xy) + g.emissive) * coverage;
    float seen = dot(through, vec3(1.0 / 3.0));
    radiance = vec4(min(behindFog(lit, vec3(1.0) - through), RL_MAX_RADIANCE), 1.0 - seen);
    passing = vec4(through, seen);
#else
    vec3 lit = lightSurface(s, gl_FragCoord.xy) + g.emissive;
    radiance = vec4(min(behindFog(lit), RL_MAX_RADIANCE) * g.baseColor.a, g.baseColor.a);
#endif
#endif
}

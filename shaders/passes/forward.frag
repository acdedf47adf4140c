// What the G-buffer cannot hold: blended surfaces, and (EMISSION_ONLY) the light that moving surfaces give off.
#include "common/material.glsl"
#include "common/lighting_block.glsl"
#include "common/lighting.glsl"

layout(std140, binding = RL_UNIFORMS_VIEW) uniform ViewBlock { ViewUniforms view; };

layout(location = 0) out vec4 radiance;  // premultiplied

void main() {
    SurfaceSample g = sampleSurface();
#if defined(EMISSION_ONLY)
    radiance = vec4(g.emissive, 0.0);
#elif defined(UNLIT)
    radiance = vec4(g.baseColor.rgb * g.baseColor.a, g.baseColor.a);
#else
    vec3 towardsEye = view.cameraPosition.w > 0.5 ? -normalize(surfacePosition)
                                                  : -view.cameraForward.xyz;
    float viewDepth = dot(surfacePosition, view.cameraForward.xyz);
    LitSurface s = makeLitSurface(surfacePosition, viewDepth, towardsEye, g.normal,
                                  g.baseColor.rgb, g.metallic, g.roughness, g.occlusion);
    vec3 lit = lightSurface(s, gl_FragCoord.xy) + g.emissive;
    radiance = vec4(min(lit, RL_MAX_RADIANCE) * g.baseColor.a, g.baseColor.a);
#endif
}

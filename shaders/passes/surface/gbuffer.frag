#include "common/surface/gbuffer.glsl"
#include "common/surface/material.glsl"
#if defined(DECALS)
layout(std140, binding = RL_UNIFORMS_VIEW) uniform ViewBlock { ViewUniforms view; };
#include "common/surface/decals.glsl"
#endif

layout(location = 0) out vec4 target0;
layout(location = 1) out vec4 target1;
layout(location = 2) out vec4 target2;

void main() {
    SurfaceSample s = sampleSurface();
#if defined(DECALS) && !defined(UNLIT)
    s.normal = normalize(s.normal);
    applyDecals(surfacePosition, gl_FragCoord.xy, s.baseColor.rgb, s.normal, s.roughness,
                s.metallic);
#endif
    vec3 packed24 = vec3(0.0);
    int kind = RL_SURFACE_AT_REST;
#if defined(UNLIT)
    kind = RL_SURFACE_UNLIT;
#elif defined(MOVING)
    vec2 now = surfaceClip.xy / surfaceClip.w;
    vec2 before = surfacePreviousClip.xy / surfacePreviousClip.w;
    packed24 = packVelocity((now - before) * 0.5);
    kind = RL_SURFACE_MOVING;
#elif defined(EMISSIVE)
    packed24 = packEmissive(s.emissive);
#endif
    GBufferTexels t = encodeGBuffer(s.baseColor.rgb, s.metallic, s.normal, s.roughness, packed24,
                                    s.occlusion, kind);
    target0 = t.target0;
    target1 = t.target1;
    target2 = t.target2;
}

// The light of reflection probes around a point: see interop/reflection_probe.h.
#include "interop/reflection_probe.h"

layout(binding = RL_TEXTURE_REFLECTION_CUBES) uniform samplerCubeArray reflectionCubes;
#if !defined(IRRADIANCE_VOLUME)
layout(binding = RL_TEXTURE_REFLECTION_IRRADIANCE) uniform samplerCubeArray reflectionIrradiance;
#endif
layout(binding = RL_TEXTURE_REFLECTION_RECORDS) uniform samplerBuffer reflectionRecords;

// Smaller boxes are before larger ones, and each leaves to the next what it does not cover: the shares add up to one, with
// what is left for the surroundings beyond all boxes, and none jumps where a box begins.
void gatherReflectionProbes(inout LitSurface s) {
    s.probesMirrored = vec3(0.0);
    s.probesIrradiance = vec3(0.0);
    s.beyondProbes = 1.0;
    vec3 r = reflect(-s.point.view, s.point.normal);
    int count = int(texelFetch(reflectionRecords, 0).x + 0.5);
    float lastLevel = float(textureQueryLevels(reflectionCubes) - 1);
    for (int i = 0; i < count; ++i) {
        int texel = 1 + i * RL_REFLECTION_TEXELS;
        vec4 row0 = texelFetch(reflectionRecords, texel);
        vec4 row1 = texelFetch(reflectionRecords, texel + 1);
        vec4 row2 = texelFetch(reflectionRecords, texel + 2);
        vec4 scale = texelFetch(reflectionRecords, texel + 4);
        vec4 at = vec4(s.position, 1.0);
        vec3 place = vec3(dot(row0, at), dot(row1, at), dot(row2, at));
        float share = s.beyondProbes *
                      reflectionInfluence(place, scale.xyz,
                                          texelFetch(reflectionRecords, texel + 5).xyz);
        if (share <= 0.0) continue;
        s.beyondProbes -= share;
        share *= scale.w;
        vec4 capture = texelFetch(reflectionRecords, texel + 3);
        vec3 along = vec3(dot(row0.xyz, r), dot(row1.xyz, r), dot(row2.xyz, r));
        vec3 towards = s.position + r * (distanceToBox(place, along) + 1e-4) - capture.xyz;
        s.probesMirrored += share * textureLod(reflectionCubes, vec4(towards, capture.w),
                                               clamp(s.roughness, 0.0, 1.0) * lastLevel).rgb;
#if !defined(IRRADIANCE_VOLUME)
        s.probesIrradiance +=
            share * textureLod(reflectionIrradiance, vec4(s.bent, capture.w), 0.0).rgb;
#endif
    }
    s.beyondProbes = max(s.beyondProbes, 0.0);
}

// Light that is not the same in all directions: IES profiles and cookies of the modulated class. Layout of their records:
// GpuLightModulation in renderer/lighting/clusters/light_clusters.h.
#include "interop/light_patterns.h"

layout(binding = RL_TEXTURE_LIGHT_PATTERNS) uniform sampler2DArray lightPatterns;

/// `modulation`: the first texel of the record. `footprint`: metres that a pixel spans where the light falls.
vec3 lightPattern(LightSample light, vec4 modulation, float footprint) {
    vec4 right = texelFetch(lightTexels, light.texel + 4);
    vec4 up = texelFetch(lightTexels, light.texel + 5);
    vec3 forward = texelFetch(lightTexels, light.texel + 2).xyz;
    vec3 d = -vec3(dot(light.direction, right.xyz), dot(light.direction, up.xyz),
                   dot(light.direction, forward));
    vec3 factor = vec3(1.0);
    if (modulation.z > 0.0) {
        vec2 angles = webAngles(d, right.w);
        factor = textureLod(lightPatterns, vec3(webCoordinates(angles), modulation.z - 1.0), 0.0).rgb;
        if (angles.y > 1.0) factor = vec3(0.0);
    }
    if (modulation.w > 0.0) {
        float texels = cookieTexelsPerRadian(d, up.w) * footprint *
                       inversesqrt(max(light.distanceSquared, 1e-8));
        factor *= textureLod(lightPatterns, vec3(cookieCoordinates(d, up.w), modulation.w - 1.0),
                             log2(max(texels, 1.0))).rgb;
    }
    return factor;
}

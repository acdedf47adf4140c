#include "common/light/lighting_varyings.glsl"

#if defined(ENVIRONMENT)
layout(binding = RL_TEXTURE_SKY) uniform samplerCube sky;
#endif

layout(location = 0) out vec4 radiance;

void main() {
#if defined(ENVIRONMENT)
    vec2 turn = flatEnvironment.xy;
    vec3 d = pixelRay;
    vec3 turned = vec3(turn.x * d.x - turn.y * d.z, d.y, turn.y * d.x + turn.x * d.z);
    vec3 light = textureLod(sky, turned, 0.0).rgb * flatEnvironment.z;
    float inside = dot(normalize(d), flatSunDisk.xyz);
    // The rim is a tenth of the radius wide; limb darkening: Hestroffer and Magnan 1998, at 550 nm.
    float rim = (1.0 - inside) / (1.0 - flatSunDisk.w);
    float limb = pow(clamp(1.0 - rim, 0.0, 1.0), 0.26) * (1.0 - smoothstep(0.8, 1.0, rim));
    light += flatSunDiskRadiance.rgb * limb;
    radiance = vec4(min(light, RL_MAX_RADIANCE), 1.0);
#else
    radiance = flatBackground;
#endif
}

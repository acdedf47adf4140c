#include "common/lighting_varyings.glsl"

#if defined(ENVIRONMENT)
layout(binding = RL_TEXTURE_SKY) uniform samplerCube sky;
#endif

layout(location = 0) out vec4 radiance;

void main() {
#if defined(ENVIRONMENT)
    vec2 turn = flatEnvironment.xy;
    vec3 d = pixelRay;
    vec3 turned = vec3(turn.x * d.x - turn.y * d.z, d.y, turn.y * d.x + turn.x * d.z);
    radiance = vec4(textureLod(sky, turned, 0.0).rgb * flatEnvironment.z, 1.0);
#else
    radiance = flatBackground;
#endif
}

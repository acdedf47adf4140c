// Light around each second pixel of each second row: see common/light/local_light.glsl.
#include "common/surface/gbuffer.glsl"
#include "common/light/lighting_varyings.glsl"
#include "common/light/irradiance_probes.glsl"

layout(binding = RL_TEXTURE_GBUFFER1) uniform sampler2D gbuffer1;
layout(binding = RL_TEXTURE_DEPTH) uniform sampler2D depthMap;

layout(location = 0) out vec4 localTint;  // a: metres from the eye; 0: background
layout(location = 1) out vec4 localFlow;  // rgb: -1 to 1 as bytes 1 to 255

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) * 2;
    float depth = texelFetch(depthMap, pixel, 0).x;
    localTint = vec4(0.0);
    localFlow = vec4(0.5);
    if (depth > 0.0) {
        vec3 normal = unpackNormal(texelFetch(gbuffer1, pixel, 0).rgb);
        float linear = depth * flatDepthDecode.x + flatDepthDecode.y;
#if defined(ORTHOGRAPHIC)
        float viewDepth = linear;
#else
        float viewDepth = 1.0 / linear;
#endif
        vec3 tint, flow;
        shareableLight(lightAround(pixelBase + pixelRay * viewDepth, normal), normal, tint, flow);
        localTint = vec4(min(tint, vec3(65504.0)), viewDepth);
        localFlow = vec4(flow * (127.0 / 255.0) + (128.0 / 255.0), 1.0);
    }
}

// The fog before surfaces and background, over what they send.
#include "common/light/lighting_block.glsl"
#define FOG_LOOKUP
#include "common/screen/fog.glsl"

layout(binding = RL_TEXTURE_DEPTH) uniform sampler2D depthMap;

layout(location = 0) in vec2 screenUv;
layout(location = 1) in vec3 pixelRay;
layout(location = 2) in vec3 pixelBase;  // zero for a perspective view
layout(location = 3) flat in vec4 flatDepthDecode;

layout(location = 0) out vec4 radiance;  // premultiplied

void main() {
    float depth = textureLod(depthMap, screenUv, 0.0).x;
    float linear = depth * flatDepthDecode.x + flatDepthDecode.y;
#if defined(ORTHOGRAPHIC)
    float viewDepth = depth > 0.0 ? linear : 1e6;
#else
    float viewDepth = depth > 0.0 ? 1.0 / linear : 1e6;
#endif
    radiance = fogAt(gl_FragCoord.xy, pixelBase, pixelRay, viewDepth);
}

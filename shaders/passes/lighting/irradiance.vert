// A triangle over the target of half the size; its texel (x, y) is the pixel (2 x, 2 y) of the G-buffer.
#define VERTEX_STAGE
#include "common/light/lighting_varyings.glsl"

layout(binding = RL_TEXTURE_DEPTH) uniform sampler2D depthMap;

void main() {
    vec2 uv = vec2(float(gl_VertexID & 1) * 2.0, float(gl_VertexID >> 1) * 2.0);
    vec2 size = vec2(textureSize(depthMap, 0));
    vec2 halfSize = floor((size + 1.0) * 0.5);
    writeLightingVaryings((uv * (2.0 * halfSize) - 0.5) / size);
    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}

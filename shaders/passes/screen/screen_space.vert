// A triangle over the whole target; see common/screen/screen_space.glsl.
#define VERTEX_STAGE
#include "common/screen/screen_space.glsl"

layout(std140, binding = RL_UNIFORMS_PASS) uniform ScreenBlock { ScreenUniforms screen; };

void main() {
    vec2 corner = vec2(float(gl_VertexID & 1) * 2.0, float(gl_VertexID >> 1) * 2.0);
    flatViewFromTexel = screen.viewFromTexel;
    flatDepthDecode = screen.depthDecode;
    flatSize = screen.size;
    flatRight = screen.right;
    flatUp = screen.up;
    flatBack = screen.back;
    flatSettings = screen.settings;
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}

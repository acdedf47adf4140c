// A triangle over the whole target, with no vertex buffer. FULLSCREEN_Z is its depth: 0 is infinitely far, so that
// CompareOp::less draws surfaces alone and CompareOp::greaterOrEqual the background alone.
#define VERTEX_STAGE
#include "common/fullscreen.glsl"

#if !defined(FULLSCREEN_Z)
#define FULLSCREEN_Z 0.0
#endif

layout(std140, binding = RL_UNIFORMS_PASS) uniform PassBlock { PassUniforms pass; };

void main() {
    vec2 corner = vec2(float(gl_VertexID & 1) * 2.0, float(gl_VertexID >> 1) * 2.0);
    uv = pass.counts.w > 0.5 ? vec2(corner.x, 1.0 - corner.y) : corner;
    flatSourceTexel = pass.sourceTexel;
    flatSettings = pass.settings;
    flatCounts = pass.counts;
    gl_Position = vec4(corner * 2.0 - 1.0, FULLSCREEN_Z, 1.0);
}

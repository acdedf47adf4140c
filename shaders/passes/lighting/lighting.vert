// A triangle over the whole screen at the far plane: drawn where the depth is nearer (lighting) or not (background).
#define VERTEX_STAGE
#include "common/light/lighting_varyings.glsl"

void main() {
    vec2 uv = vec2(float(gl_VertexID & 1) * 2.0, float(gl_VertexID >> 1) * 2.0);
    writeLightingVaryings(uv);
    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}

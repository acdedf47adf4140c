// Mean log2 luminance of the target texel's share of a small bloom level, by four bilinear samples.
#include "common/fullscreen.glsl"
#include "interop/tonemap.h"

layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2D source;

layout(location = 0) out float mean;

float load(float x, float y) {
    vec3 c = textureLod(source, uv + vec2(x, y) * flatSourceTexel.xy, 0.0).rgb;
    return log2(max(luminance(c), 1e-5));
}

void main() {
    mean = 0.25 * (load(-1.0, -1.0) + load(1.0, -1.0) + load(-1.0, 1.0) + load(1.0, 1.0));
}

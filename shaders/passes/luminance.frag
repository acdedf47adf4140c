// One step of averaging log2 luminance: each target texel is the mean of its 4x4 source texels, by four bilinear
// samples. FIRST takes the logarithm of the colours of a small bloom level.
#include "common/fullscreen.glsl"
#include "interop/tonemap.h"

layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2D source;

layout(location = 0) out float mean;

#if defined(FIRST)
float load(float x, float y) {
    vec3 c = textureLod(source, uv + vec2(x, y) * flatSourceTexel.xy, 0.0).rgb;
    return log2(max(luminance(c), 1e-5));
}
#else
float load(float x, float y) {
    return textureLod(source, uv + vec2(x, y) * flatSourceTexel.xy, 0.0).x;
}
#endif

void main() {
    mean = 0.25 * (load(-1.0, -1.0) + load(1.0, -1.0) + load(-1.0, 1.0) + load(1.0, 1.0));
}

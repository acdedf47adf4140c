// Twice the size: a 3x3 tent from four bilinear samples, mixed over what the finer level holds. Blended premultiplied with
// alpha = settings.x, the coarser level's share, so energy stays.
#include "common/fullscreen.glsl"

layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2D source;

layout(location = 0) out vec4 bloom;

vec3 load(float x, float y) {
    return textureLod(source, uv + vec2(x, y) * flatSourceTexel.xy, 0.0).rgb;
}

void main() {
    vec3 sum = load(-0.5, -0.5) + load(0.5, -0.5) + load(-0.5, 0.5) + load(0.5, 0.5);
    float share = flatSettings.x;
    bloom = vec4(sum * (0.25 * share), share);
}

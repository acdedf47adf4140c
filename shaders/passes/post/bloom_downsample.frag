// Half the size. Bjorge 2015, "Bandwidth-Efficient Rendering", dual filtering: a centre and four diagonal bilinear
// samples at half-texel offsets of the target.
// FIRST: reads the scene. The four are weighted by 1 / (1 + luminance), softly, so that a single very bright pixel does
// not flicker as it moves (Karis 2013, "Tone Mapping"; Jimenez 2014).
#include "common/fullscreen.glsl"
#include "interop/tonemap.h"

layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2D source;

layout(location = 0) out vec4 bloom;

vec3 load(float x, float y) {
    return textureLod(source, uv + vec2(x, y) * flatSourceTexel.xy, 0.0).rgb;
}

void main() {
    vec3 a = load(-1.0, -1.0);
    vec3 b = load(1.0, -1.0);
    vec3 c = load(-1.0, 1.0);
    vec3 d = load(1.0, 1.0);
#if defined(FIRST)
    // Bounded: a half-float infinity would spread over everything. NaN becomes 0 in max.
    a = min(max(a, 0.0), 60000.0);
    b = min(max(b, 0.0), 60000.0);
    c = min(max(c, 0.0), 60000.0);
    d = min(max(d, 0.0), 60000.0);
    vec4 weights = 1.0 / (1.0 + vec4(luminance(a), luminance(b), luminance(c), luminance(d)));
    vec3 sum = a * weights.x + b * weights.y + c * weights.z + d * weights.w;
    bloom = vec4(sum / dot(weights, vec4(1.0)), 1.0);
#else
    vec3 center = load(0.0, 0.0);
    bloom = vec4(center * 0.5 + (a + b + c + d) * 0.125, 1.0);
#endif
}

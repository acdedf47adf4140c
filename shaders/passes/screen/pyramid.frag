// All levels of the pyramid in one pass: each texel sums up its part of level 0, so that every level reads as much as the
// next and none waits for another.
#include "common/screen/screen_space.glsl"
#include "common/screen/pyramid.glsl"

layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2D baseRadiance;  // linear
layout(binding = RL_TEXTURE_SOURCE1) uniform sampler2D baseNearest;

layout(location = 0) out vec4 radiance;
layout(location = 1) out float nearest;

void main() {
    ivec2 size = ivec2(flatRight.w, flatUp.w);
    ivec2 texel = ivec2(gl_FragCoord.xy);
    if (texel.x < size.x) {
        ivec2 at = min(texel, size - 1);
        radiance = texelFetch(baseRadiance, at, 0);
        nearest = texelFetch(baseNearest, at, 0).x;
        return;
    }
    int level = 1;
    for (int i = 2; i < PYRAMID_LEVELS; ++i) level = texel.y >= pyramidOrigin(i).y ? i : level;
    ivec2 first = (texel - pyramidOrigin(level)) << level;
    bool used = first.x < size.x && first.y < size.y;
    int half_ = used ? 1 << (level - 1) : 0;
    vec3 sum = vec3(0.0);
    float most = 0.0;
    for (int y = 0; y < half_; ++y)
        for (int x = 0; x < half_; ++x) {
            ivec2 low = min(first + ivec2(x, y) * 2, size - 1);
            ivec2 high = min(low + 1, size - 1);
            sum += textureLod(baseRadiance, (vec2(low) + 1.0) / vec2(size), 0.0).rgb;
            most = max(most, max(max(texelFetch(baseNearest, low, 0).x,
                                     texelFetch(baseNearest, high, 0).x),
                                 max(texelFetch(baseNearest, ivec2(low.x, high.y), 0).x,
                                     texelFetch(baseNearest, ivec2(high.x, low.y), 0).x)));
        }
    radiance = vec4(sum / float(max(half_ * half_, 1)), 1.0);
    nearest = most;
}

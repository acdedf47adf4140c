// The scene at half the size: of 2x2 pixels the mean radiance and the nearest depth.
#include "common/screen/screen_space.glsl"

layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2D radianceMap;  // linear
layout(binding = RL_TEXTURE_DEPTH) uniform sampler2D depthMap;

layout(location = 0) out vec4 radiance;
layout(location = 1) out float nearest;

void main() {
    ivec2 low = ivec2(gl_FragCoord.xy) * 2;
    ivec2 high = min(low + 1, ivec2(flatSize.xy) - 1);
    nearest = max(max(texelFetch(depthMap, low, 0).x, texelFetch(depthMap, high, 0).x),
                  max(texelFetch(depthMap, ivec2(low.x, high.y), 0).x,
                      texelFetch(depthMap, ivec2(high.x, low.y), 0).x));
    vec3 mean = textureLod(radianceMap, (vec2(low) + 1.0) / flatSize.xy, 0.0).rgb;
    // A half-float infinity would spread over all levels. NaN becomes 0 in max.
    radiance = vec4(min(max(mean, 0.0), 60000.0), 1.0);
}

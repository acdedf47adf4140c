// Automatic exposure into one texel: the factor that brings the mean log luminance to the aim, approached from the last
// frame's by a share that follows from the time between them.
#include "common/fullscreen.glsl"

layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2D meanLogLuminance;
layout(binding = RL_TEXTURE_SOURCE1) uniform sampler2D previousExposure;

layout(location = 0) out float exposure;

void main() {
    // The image of means is 4 x 4.
    float sum = 0.0;
    for (int i = 0; i < 16; ++i)
        sum += textureLod(meanLogLuminance, (vec2(float(i & 3), float(i >> 2)) + 0.5) * 0.25, 0.0).x;
    float aim = clamp(flatSettings.w * exp2(-sum * (1.0 / 16.0)), flatSettings.y, flatSettings.z);
    float last = textureLod(previousExposure, vec2(0.5), 0.0).x;
    // In stops, as eyes adapt. Nothing before the first frame: 0. After a cut the share is all, and the aim is taken as it
    // is: what was before may not show in the last bit.
    float adapted = exp2(mix(log2(max(last, 1e-6)), log2(aim), flatSettings.x));
    exposure = last > 0.0 && flatSettings.x < 1.0 ? adapted : aim;
}

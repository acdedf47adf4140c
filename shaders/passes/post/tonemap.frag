// Linear radiance to display: bloom, exposure, tone map, sRGB curve, dithering to 8 bits.
// TONE_MAP_NEUTRAL | TONE_MAP_AGX | TONE_MAP_ACES, else none; BLOOM, AUTO_EXPOSURE, DITHER, TRANSPARENT |
// LUMA_IN_ALPHA (for FXAA).
#include "common/fullscreen.glsl"
#include "interop/tonemap.h"

layout(binding = RL_TEXTURE_SOURCE0) uniform sampler2D scene;
#if defined(BLOOM)
layout(binding = RL_TEXTURE_SOURCE1) uniform sampler2D bloomMap;
#endif
#if defined(AUTO_EXPOSURE)
layout(binding = RL_TEXTURE_SOURCE2) uniform sampler2D exposureMap;
#endif

layout(location = 0) out vec4 display;

vec3 toneMap(vec3 c) {
#if defined(TONE_MAP_NEUTRAL)
    return saturate3(toneMapNeutral(c));
#elif defined(TONE_MAP_AGX)
    return saturate3(toneMapAgx(c));
#elif defined(TONE_MAP_ACES)
    return toneMapAces(c);
#else
    return saturate3(c);
#endif
}

void main() {
    vec4 radiance = textureLod(scene, uv, 0.0);
    vec3 color = radiance.rgb;
    float alpha = 1.0;
#if defined(TRANSPARENT)
    alpha = clamp(radiance.a, 0.0, 1.0);
#endif
#if defined(BLOOM)
    color = mix(color, textureLod(bloomMap, uv, 0.0).rgb, flatSettings.x);
#endif
    float exposure = flatSettings.y;
#if defined(AUTO_EXPOSURE)
    exposure *= textureLod(exposureMap, vec2(0.5), 0.0).x;
#endif
#if defined(TRANSPARENT)
    // The file has straight alpha: tone map what the surface itself looks like.
    exposure = alpha > 0.0 ? exposure / max(alpha, 1.0 / 255.0) : 0.0;
#endif
    vec3 encoded = encodeSrgb(toneMap(max(color * exposure, 0.0)));
#if defined(DITHER)
    encoded = dithered(encoded, gl_FragCoord.xy);
#endif
#if defined(LUMA_IN_ALPHA)
    alpha = dot(encoded, vec3(0.299, 0.587, 0.114));
#endif
    display = vec4(encoded, alpha);
}

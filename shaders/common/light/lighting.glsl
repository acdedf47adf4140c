// Direct light of suns and clustered lights, shadows, and the ambient term: one source for deferred and forward.
// Constants are read as `L_...`: from the block (lighting_block.glsl), or from flat varyings that the full-screen vertex
// shader copied (lighting_varyings.glsl): llvmpipe reads those three times as fast.
#include "interop/bindings.h"
#include "interop/frame_uniforms.h"
#include "common/surface/lit_surface.glsl"
#if defined(SUN_SHADOW) || defined(PUNCTUAL_SHADOW) || defined(AREA_SHADOW)
#include "common/shadow/shadow_filter.glsl"
#include "common/shadow/glass_shadow.glsl"
#endif
#if defined(SUN_SHADOW)
#include "common/shadow/sun_shadow.glsl"
#endif
#if defined(SUN_CONTACT) || defined(LIGHT_CONTACT)
#include "common/shadow/contact_shadow.glsl"
#endif
#if defined(PUNCTUAL_SHADOW) || defined(AREA_SHADOW) || defined(SHADOWED_SUNS)
#include "common/shadow/shadow_faces.glsl"
#endif
#if defined(SHADOWED_SUNS)
#include "common/light/second_suns.glsl"
#endif
#if defined(PUNCTUAL_SHADOW)
#include "common/shadow/punctual_shadow.glsl"
#endif
#if defined(AREA_SHADOW)
#include "common/shadow/area_shadow.glsl"
#endif
#if defined(CLUSTERED_LIGHTS)
#include "common/light/clustered_lights.glsl"
#endif
#include "common/light/ambient.glsl"

vec3 otherSun(int sun, vec3 towards, vec3 illuminance, LitSurface s) {
    vec3 light = evaluateBrdf(s.point, towards) * illuminance;
#if defined(SHADOWED_SUNS)
    if (sun < SHADOWED_SUNS) light *= secondSunVisibility(sun - 1, s, towards);
#endif
    return light;
}

vec3 directionalLight(LitSurface s) {
    vec3 sum = vec3(0.0);
#if DIRECTIONAL_LIGHTS > 0
    {
        vec3 l = L_DIRECTION(0).xyz;
        vec3 light = evaluateBrdf(s.point, l) * L_ILLUMINANCE(0).rgb;
#if defined(SUN_SHADOW)
        light *= sunVisibility(s, l);
#endif
#if defined(SUN_CONTACT)
        light *= contactVisibility(s, contactScreen(), l, L_CONTACT_LENGTH);
#endif
        sum += light;
    }
#endif
#if DIRECTIONAL_LIGHTS > 1
    sum += otherSun(1, L_DIRECTION(1).xyz, L_ILLUMINANCE(1).rgb, s);
#endif
#if DIRECTIONAL_LIGHTS > 2
    sum += otherSun(2, L_DIRECTION(2).xyz, L_ILLUMINANCE(2).rgb, s);
#endif
#if DIRECTIONAL_LIGHTS > 3
    sum += otherSun(3, L_DIRECTION(3).xyz, L_ILLUMINANCE(3).rgb, s);
#endif
    return sum;
}

vec3 lightSurface(LitSurface s, vec2 pixel) {
    vec3 radiance = directionalLight(s) + ambientLight(s);
#if defined(CLUSTERED_LIGHTS)
    radiance += clusteredLight(s, pixel);
#endif
    return radiance;
}

// Light from all around that a surface mirrors: added by lighting, and taken away again, term by term the same, where
// reflections of the screen know better (passes/screen/reflections_composite.frag).
#if defined(AMBIENT_OCCLUSION)
#include "interop/occlusion_arc.h"
#endif

#if defined(IRRADIANCE_VOLUME)
#include "interop/irradiance_volume.h"
#endif

#if defined(REFLECTION_PROBES)
#include "common/light/reflection_probes.glsl"
#endif

#if defined(ENVIRONMENT)
layout(binding = RL_TEXTURE_ENVIRONMENT) uniform samplerCube environmentMap;

vec3 turnToEnvironment(vec3 d) {
    vec2 turn = L_ENVIRONMENT.xy;
    return vec3(turn.x * d.x - turn.y * d.z, d.y, turn.y * d.x + turn.x * d.z);
}
#endif

vec3 diffuseAlbedo(LitSurface s) { return s.baseColor * (1.0 - s.metallic); }

// How much of what comes from around goes on towards the eye.
EnvironmentWeights ambientWeights(LitSurface s) {
#if defined(ENVIRONMENT) || defined(REFLECTION_PROBES)
    return environmentWeights(diffuseAlbedo(s), s.point.f0, s.table);
#else
    // The specular lobe of a hemisphere, without a table: Karis 2014, "Physically Based Shading on Mobile".
    vec4 k = s.roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(k.x * k.x, exp2(-9.28 * s.point.nDotV)) * k.x + k.y;
    EnvironmentWeights w;
    w.specular = specularAlbedo(s.point.f0, vec2(-1.04, 1.04) * a + k.zw);
    w.diffuse = diffuseAlbedo(s);
    return w;
#endif
}

// The radiance of the far surroundings about the mirror direction, as the surface's roughness blurs it.
vec3 farMirrored(LitSurface s) {
    vec3 r = reflect(-s.point.view, s.point.normal);
#if defined(ENVIRONMENT)
    float brightness = L_ENVIRONMENT.z;
#if defined(IRRADIANCE_VOLUME)
    // The far environment, as bright as what is around this place: Hooker 2016, "Volumetric Global Illumination at
    // Treyarch", normalises reflection probes so.
    float here = dot(s.tint, vec3(0.2126, 0.7152, 0.0722)) * irradianceShape(s.flow, r);
    float there = L_VOLUME_OUTER_LUMINANCE.x * irradianceShape(L_VOLUME_OUTER_LUMINANCE.yzw, r);
    brightness *= clamp(here / max(there, 1e-6), 0.0, 4.0);
#endif
    return textureLod(environmentMap, turnToEnvironment(r),
                      environmentLevel(s.roughness, L_ENVIRONMENT.w)).rgb * brightness;
#elif defined(IRRADIANCE_VOLUME)
    return s.tint * irradianceShape(s.flow, r);
#elif defined(HEMISPHERE)
    return mix(L_AMBIENT_GROUND.rgb, L_AMBIENT_SKY.rgb, r.y * 0.5 + 0.5);
#else
    return vec3(0.0);
#endif
}

// What probes captured, as it is, where they are; with an irradiance volume too: the captured light was seen through it.
vec3 surroundingsMirrored(LitSurface s) {
#if defined(REFLECTION_PROBES)
    return s.probesMirrored + s.beyondProbes * farMirrored(s);
#else
    return farMirrored(s);
#endif
}

#if defined(AMBIENT_OCCLUSION)
// How much of a cone `lobe` is in a cone `open`, by half their angles and the cosines of those; `cosine` is that of the
// angle between their axes. Oat and Sander 2007, "Ambient Aperture Lighting".
float coneShare(vec2 open, vec2 lobe, float cosine) {
    float apart = abs(open.x - lobe.x);
    float between = arcCosine(clamp(cosine, -1.0, 1.0));
    float t = clamp((between - apart) / max(open.x + lobe.x - apart, 1e-4), 0.0, 1.0);
    float most = min((1.0 - open.y) / max(1.0 - lobe.y, 1e-4), 1.0);
    return most * (1.0 - t * t * (3.0 - 2.0 * t));
}
#endif

// The share of the specular lobe that is open: Jimenez et al. 2016 (see interop/occlusion_arc.h), section 5, the lobe and
// the open sky as cones. Against the share that an open hemisphere leaves of the lobe: that one is in the weights.
float specularVisibility(LitSurface s) {
#if defined(AMBIENT_OCCLUSION)
    float rough = clampRoughness(s.roughness);
    float lobeCosine = exp2(-3.32193 * rough * rough);  // 10^-alpha: most of a lobe of this roughness
    float openCosine = sqrt(1.0 - s.visible);  // a cone about the normal with this visibility: its sine^2
    vec2 lobe = vec2(arcCosine(lobeCosine), lobeCosine);
    vec3 r = reflect(-s.point.view, s.point.normal);
    float share = coneShare(vec2(arcCosine(openCosine), openCosine), lobe, dot(r, s.bent));
    float whole = coneShare(vec2(kHalfPi, 0.0), lobe, dot(r, s.point.normal));
    return min(share / max(whole, 1e-3), s.occlusion);
#else
    return s.occlusion;
#endif
}

// What lighting adds; see ambientWeights for `weights`.
vec3 ambientSpecular(LitSurface s, EnvironmentWeights weights) {
    return weights.specular * surroundingsMirrored(s) * specularVisibility(s);
}

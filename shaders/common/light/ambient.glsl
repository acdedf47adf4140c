// Light from everywhere: irradiance probes, an environment, or a hemisphere.
#if defined(ENVIRONMENT) || defined(HEMISPHERE) || defined(IRRADIANCE_VOLUME) || \
    defined(REFLECTION_PROBES)
#include "common/light/ambient_specular.glsl"

#if defined(ENVIRONMENT) && !defined(IRRADIANCE_VOLUME)
layout(binding = RL_TEXTURE_IRRADIANCE) uniform samplerCube irradianceMap;
#endif

// Irradiance over pi that a surface with the normal n would get if nothing hid it.
vec3 farIrradiance(LitSurface s, vec3 n) {
#if defined(IRRADIANCE_VOLUME)
    return s.tint * irradianceShape(s.flow, n);
#elif defined(ENVIRONMENT)
    return textureLod(irradianceMap, turnToEnvironment(n), 0.0).rgb * L_ENVIRONMENT.z;
#elif defined(HEMISPHERE)
    return mix(L_AMBIENT_GROUND.rgb, L_AMBIENT_SKY.rgb, n.y * 0.5 + 0.5);
#else
    return vec3(0.0);
#endif
}

vec3 ambientIrradiance(LitSurface s, vec3 n) {
#if defined(REFLECTION_PROBES) && !defined(IRRADIANCE_VOLUME)
    return s.probesIrradiance + s.beyondProbes * farIrradiance(s, n);
#else
    return farIrradiance(s, n);
#endif
}

vec3 diffuseVisibility(LitSurface s) {
#if defined(AMBIENT_OCCLUSION)
    // The light that the hiding surfaces themselves send on, if they are as bright as this one. Jimenez et al. 2016,
    // section 6: a cubic fitted to path-traced scenes of one albedo.
    vec3 albedo = s.baseColor;
    float v = min(s.visible, s.occlusion);
    vec3 a = 2.0404 * albedo - 0.3324;
    vec3 b = -4.7951 * albedo + 0.6417;
    vec3 c = 2.7552 * albedo + 0.6903;
    return max(vec3(v), ((v * a + b) * v + c) * v);
#else
    return vec3(s.occlusion);
#endif
}

vec3 ambientLight(LitSurface s) {
#if defined(REFLECTION_PROBES)
    gatherReflectionProbes(s);
#endif
    EnvironmentWeights w = ambientWeights(s);
    vec3 light = w.diffuse * ambientIrradiance(s, s.bent) * diffuseVisibility(s);
#if !defined(NO_AMBIENT_REFLECTIONS)
    light += ambientSpecular(s, w);
#endif
    return light;
}
#else
vec3 ambientLight(LitSurface s) { return vec3(0.0); }
#endif

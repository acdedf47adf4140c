// The reflectance of glTF 2.0's metallic-roughness model and the falloff of KHR_lights_punctual,
// for every shader and for the CPU path tracer.
//
// Sources: glTF 2.0 specification, appendix B (BRDF); KHR_lights_punctual (attenuation, spot cone);
// Walter et al. 2007 (GGX); Heitz 2014, "Understanding the Masking-Shadowing Function"
// (height-correlated Smith); Fdez-Aguera 2019, "A Multiple-Scattering Microfacet Model for
// Real-Time Image-based Lighting", JCGT 8(1); Turquin 2019, "Practical multiple scattering
// compensation for microfacet models".
#ifndef RL_INTEROP_BRDF_H
#define RL_INTEROP_BRDF_H

#include "interop/interop.h"

RL_INTEROP_BEGIN

RL_CONST float kInversePi = 0.318309886183790671f;
RL_CONST float kDielectricF0 = 0.04f;
/// Below this the GGX peak exceeds what 32-bit floats and 24-bit normals resolve.
RL_CONST float kMinRoughness = 0.045f;
RL_CONST float kMinNdotV = 1e-4f;

RL_INLINE float pow5(float x) {
    float x2 = x * x;
    return x2 * x2 * x;
}

// ---- terms
// -------------------------------------------------------------------------------------------------------

RL_INLINE float clampRoughness(float roughness) { return clamp(roughness, kMinRoughness, 1.0f); }

/// GGX normal distribution; `alpha2` = roughness to the fourth.
RL_INLINE float distributionGgx(float nDotH, float alpha2) {
    float c2 = min(nDotH * nDotH, 1.0f);
    float d = alpha2 * c2 + (1.0f - c2);
    return alpha2 * kInversePi / (d * d);
}

/// The root in Smith's masking term of one direction, which a light loop computes once for the
/// view.
RL_INLINE float smithRoot(float nDotX, float alpha2) {
    return sqrt(nDotX * nDotX * (1.0f - alpha2) + alpha2);
}

/// Height-correlated Smith masking-shadowing, divided by 4 nDotL nDotV.
RL_INLINE float visibilitySmith(float nDotV, float nDotL, float rootV, float rootL) {
    return 0.5f / (nDotL * rootV + nDotV * rootL);
}

RL_INLINE vec3 fresnelSchlick(vec3 f0, float vDotH) {
    return f0 + (vec3(1.0f) - f0) * pow5(clamp(1.0f - vDotH, 0.0f, 1.0f));
}

/// `table` = the split-sum integrals at (nDotV, roughness): the specular albedo under white light
/// is f0 * x + y.
RL_INLINE vec3 specularAlbedo(vec3 f0, vec2 table) { return f0 * table.x + vec3(table.y); }

#define RL_BRDF_TABLE_SIZE 64
/// Where that table holds (nDotV, roughness), in texture coordinates: the outermost texels' centres
/// are 0 and 1.
RL_INLINE vec2 brdfTableCoordinates(float nDotV, float roughness) {
    float size = float(RL_BRDF_TABLE_SIZE);
    return vec2(nDotV, clampRoughness(roughness)) * ((size - 1.0f) / size) + vec2(0.5f / size);
}

/// Turquin's factor on the single-scattering specular lobe that gives back what masking lost.
RL_INLINE vec3 multipleScatteringScale(vec3 f0, vec2 table) {
    return vec3(1.0f) + f0 * (1.0f / max(table.x + table.y, 1e-3f) - 1.0f);
}

// ---- one surface point under many lights
// -------------------------------------------------------------------------

/// All that does not depend on the light.
struct ShadingPoint {
    vec3 normal;          ///< unit
    vec3 view;            ///< unit, towards the eye
    vec3 diffuseOverPi;   ///< Lambert's albedo over pi, of the light that the specular lobe leaves
    vec3 f0;              ///< reflectance at normal incidence
    vec3 specularAlbedo;  ///< share of white light from everywhere that the specular lobe reflects
                          ///< to the eye
    vec3 lobe0, lobe90;   ///< of Schlick's Fresnel term, at normal and grazing incidence, times the
                          ///< compensation
    float nDotV;          ///< clamped away from zero
    float alpha2;         ///< roughness to the fourth
    float rootV;          ///< smithRoot(nDotV, alpha2)
};

/// `table` as specularAlbedo takes it, at (nDotV, clampRoughness(roughness)).
/// Energy: what masking takes from the specular lobe is given back by Turquin's factor, and the
/// diffuse lobe gets what the specular one, so compensated, does not reflect. A white surface under
/// white light is exactly white, where glTF's coupling of the lobes by 1 - F(v.h) gives up to a
/// third too much at grazing angles. The price is reciprocity: the factors are those of the view's
/// direction.
RL_INLINE ShadingPoint makeShadingPoint(vec3 baseColor, float metallic, float roughness,
                                        vec3 normal, vec3 view, vec2 table) {
    ShadingPoint p;
    float r = clampRoughness(roughness);
    p.normal = normal;
    p.view = view;
    p.f0 = mix(vec3(kDielectricF0), baseColor, metallic);
    vec3 compensation = multipleScatteringScale(p.f0, table);
    p.lobe0 = p.f0 * compensation;
    p.lobe90 = compensation;
    p.specularAlbedo = specularAlbedo(p.f0, table) * compensation;
    p.diffuseOverPi = baseColor * ((1.0f - metallic) * kInversePi) *
                      max(vec3(1.0f) - p.specularAlbedo, vec3(0.0f));
    p.nDotV = clamp(dot(normal, view), kMinNdotV, 1.0f);
    p.alpha2 = r * r * r * r;
    p.rootV = smithRoot(p.nDotV, p.alpha2);
    return p;
}

/// BRDF times nDotL for the unit direction `light` towards the light; zero from below the surface.
/// With H = v + l, not normalised: n.h = (n.v + n.l) / |H| and v.h = |H| / 2. |H|^2 is summed from
/// H itself: its other form, 2 + 2 v.l, loses four digits at grazing angles.
RL_INLINE vec3 evaluateBrdf(ShadingPoint p, vec3 light) {
    float rawNdotL = dot(p.normal, light);
    float nDotL = clamp(rawNdotL, 0.0f, 1.0f);
    vec3 sum = p.view + light;
    float halfLength2 = max(dot(sum, sum), 1e-6f);
    float inverseHalf = inversesqrt(halfLength2);
    float nDotH = (dot(p.normal, p.view) + rawNdotL) * inverseHalf;
    float vDotH = 0.5f * halfLength2 * inverseHalf;

    vec3 fresnel = p.lobe0 + (p.lobe90 - p.lobe0) * pow5(clamp(1.0f - vDotH, 0.0f, 1.0f));
    float specular = distributionGgx(nDotH, p.alpha2) *
                     visibilitySmith(p.nDotV, nDotL, p.rootV, smithRoot(nDotL, p.alpha2));
    return (p.diffuseOverPi + fresnel * specular) * nDotL;
}

// ---- environment light, with multiple scattering
// -----------------------------------------------------------------

/// What multiplies the two parts of environment light.
struct EnvironmentWeights {
    vec3 specular;  ///< times prefiltered radiance along the reflection
    vec3 diffuse;   ///< times irradiance over pi at the normal
};

/// Fdez-Aguera's equations 18 to 22. Energy: a white surface under white light gives exactly white,
/// since the diffuse part is what specular single and multiple scattering leave over.
RL_INLINE EnvironmentWeights environmentWeights(vec3 diffuseAlbedo, vec3 f0, vec2 table) {
    EnvironmentWeights w;
    w.specular = specularAlbedo(f0, table);
    float lost = 1.0f - (table.x + table.y);
    vec3 averageFresnel = f0 + (vec3(1.0f) - f0) * (1.0f / 21.0f);
    vec3 multiple = w.specular * averageFresnel * lost / (vec3(1.0f) - averageFresnel * lost);
    w.diffuse = multiple + diffuseAlbedo * (vec3(1.0f) - w.specular - multiple);
    return w;
}

/// Mip level of the prefiltered cube: level = roughness * (levels - 1), linear in perceptual
/// roughness.
RL_INLINE float environmentLevel(float roughness, float levels) {
    return clamp(roughness, 0.0f, 1.0f) * (levels - 1.0f);
}

// ---- punctual lights
// ---------------------------------------------------------------------------------------------

/// What lights store instead of the range: 0 for an unbounded light.
RL_INLINE float inverseRangeSquared(float range) {
    return range > 0.0f ? 1.0f / (range * range) : 0.0f;
}

/// max(min(1 - (d / range)^4, 1), 0) / d^2
RL_INLINE float distanceAttenuation(float distanceSquared, float inverseRange2) {
    float x = distanceSquared * inverseRange2;
    return clamp(1.0f - x * x, 0.0f, 1.0f) / max(distanceSquared, 1e-8f);
}

/// x = scale, y = offset of the spot cone; angles in radians from the axis. A point light stores
/// (0, 1).
RL_INLINE vec2 spotScaleOffset(float innerAngle, float outerAngle) {
    float cosOuter = cos(outerAngle);
    float scale = 1.0f / max(0.001f, cos(innerAngle) - cosOuter);
    return vec2(scale, -cosOuter * scale);
}

/// `cosine` = dot of the spot's direction and the direction from the light to the surface.
RL_INLINE float spotAttenuation(float cosine, vec2 scaleOffset) {
    float x = clamp(cosine * scaleOffset.x + scaleOffset.y, 0.0f, 1.0f);
    return x * x;
}

RL_INTEROP_END

#endif

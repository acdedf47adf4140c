// A point that is lit: what every light, shadow and ambient term of lighting.glsl takes.
#include "interop/bindings.h"
#include "interop/brdf.h"

layout(binding = RL_TEXTURE_BRDF_TABLE) uniform sampler2D brdfTable;

struct LitSurface {
    vec3 position;  // relative to the camera, world axes
    vec4 facing;    // unit normal of the triangle, on the side of point.normal; w: 1 where it is a guess
    float viewDepth;
    vec3 baseColor;
    float metallic;
    float roughness;
    float occlusion;  // the material's
    float visible;    // by the surroundings: cosine-weighted share of the ambient light that is not hidden
    vec3 bent;        // unit: where it comes from on the mean; the normal where nothing is hidden
    vec3 tint;        // with an irradiance volume: see shareableLight of common/irradiance_probes.glsl
    vec3 flow;
#if defined(REFLECTION_PROBES)
    vec3 probesMirrored;    // see gatherReflectionProbes of common/reflection_probes.glsl
    vec3 probesIrradiance;  // over pi
    float beyondProbes;     // what they leave to the surroundings
#endif
    vec2 table;  // see specularAlbedo
    ShadingPoint point;
};

// From the neighbouring pixels' positions; those beside another surface know no better than the shading normal.
vec4 facingOf(vec3 position, vec3 normal) {
    vec3 across = cross(dFdx(position), dFdy(position));
    float size = inversesqrt(max(dot(across, across), 1e-30));
    float along = dot(across, normal) * size;
    return abs(along) > 0.9 ? vec4(across * (along < 0.0 ? -size : size), 0.0) : vec4(normal, 1.0);
}

LitSurface makeLitSurface(vec3 position, float viewDepth, vec3 view, vec3 normal, vec3 baseColor,
                          float metallic, float roughness, float occlusion) {
    LitSurface s;
    s.position = position;
    s.facing = facingOf(position, normal);
    s.viewDepth = viewDepth;
    s.baseColor = baseColor;
    s.metallic = metallic;
    s.roughness = roughness;
    s.occlusion = occlusion;
    s.visible = 1.0;
    s.bent = normal;
    s.tint = vec3(0.0);
    s.flow = vec3(0.0);
    float nDotV = clamp(dot(normal, view), kMinNdotV, 1.0);
    s.table = textureLod(brdfTable, brdfTableCoordinates(nDotV, roughness), 0.0).xy;
    s.point = makeShadingPoint(baseColor, metallic, roughness, normal, view, s.table);
    return s;
}

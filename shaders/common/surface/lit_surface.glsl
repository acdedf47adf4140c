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
    vec3 tint;        // with an irradiance volume: see shareableLight of common/light/irradiance_probes.glsl
    vec3 flow;
#if defined(REFLECTION_PROBES)
    vec3 probesMirrored;    // see gatherReflectionProbes of common/light/reflection_probes.glsl
    vec3 probesIrradiance;  // over pi
    float beyondProbes;     // what they leave to the surroundings
#endif
    vec2 table;  // see specularAlbedo
    ShadingPoint point;
};

// Of what is drawn here: a block of 2x2 pixels has positions of one triangle. (A whole picture's are of any: it has
// facingOfDepths.)
vec4 facingOf(vec3 position, vec3 normal) {
    vec3 across = cross(dFdx(position), dFdy(position));
    float area = dot(across, across);
    float side = dot(across, normal) < 0.0 ? -1.0 : 1.0;
    return area > 1e-30 ? vec4(across * (side * inversesqrt(area)), 0.0) : vec4(normal, 1.0);
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

// A point that is lit: what every light, shadow and ambient term of lighting.glsl takes.
#include "interop/bindings.h"
#include "interop/brdf.h"

layout(binding = RL_TEXTURE_BRDF_TABLE) uniform sampler2D brdfTable;

struct LitSurface {
    vec3 position;  // relative to the camera, world axes
    float viewDepth;
    vec3 baseColor;
    float metallic;
    float roughness;
    float occlusion;
    vec2 table;  // see specularAlbedo
    ShadingPoint point;
};

LitSurface makeLitSurface(vec3 position, float viewDepth, vec3 view, vec3 normal, vec3 baseColor,
                          float metallic, float roughness, float occlusion) {
    LitSurface s;
    s.position = position;
    s.viewDepth = viewDepth;
    s.baseColor = baseColor;
    s.metallic = metallic;
    s.roughness = roughness;
    s.occlusion = occlusion;
    float nDotV = clamp(dot(normal, view), kMinNdotV, 1.0);
    s.table = textureLod(brdfTable, brdfTableCoordinates(nDotV, roughness), 0.0).xy;
    s.point = makeShadingPoint(baseColor, metallic, roughness, normal, view, s.table);
    return s;
}

// A point that is lit: what every light, shadow and ambient term of lighting.glsl takes.
#include "interop/brdf.h"

struct LitSurface {
    vec3 position;  // relative to the camera, world axes
    float viewDepth;
    vec3 baseColor;
    float metallic;
    float roughness;
    float occlusion;  // the material's
    float visible;    // by the surroundings: cosine-weighted share of the ambient light that is not hidden
    vec3 bent;        // unit: where it comes from on the mean; the normal where nothing is hidden
    vec3 tint;        // with an irradiance volume: see shareableLight of common/irradiance_probes.glsl
    vec3 flow;
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
    s.visible = 1.0;
    s.bent = normal;
    s.tint = vec3(0.0);
    s.flow = vec3(0.0);
    s.point = makeShadingPoint(baseColor, metallic, roughness, normal, view);
    return s;
}

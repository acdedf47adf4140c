// Surfaces that shine: the lists' area lights (GpuAreaLight in renderer/lighting/clusters/light_clusters.h) by interop/ltc.h.
#include "interop/ltc.h"

layout(binding = RL_TEXTURE_LTC) uniform sampler2D ltcTable;

/// What all area lights need to know of a surface.
struct AreaFrame {
    vec3 tangent;  // the view is in its plane with the normal
    vec3 bitangent;
    vec4 ltc;
};

AreaFrame makeAreaFrame(LitSurface s) {
    AreaFrame f;
    vec3 n = s.point.normal;
    vec3 across = s.point.view - n * dot(n, s.point.view);
    float length2 = dot(across, across);
    f.tangent = length2 > 1e-8 ? across * inversesqrt(length2) : perpendicularTo(n);
    f.bitangent = cross(n, f.tangent);
    f.ltc = textureLod(ltcTable, ltcCoordinates(s.point.nDotV, s.roughness), 0.0);
    return f;
}

#if defined(AREA_SHADOW)
AreaSource areaSource(vec3 center, int shape, vec4 halfX, vec3 halfY, float extent) {
    AreaSource source;
    source.center = center;
    source.extent = extent;
    source.isRound = shape == RL_AREA_DISK || shape == RL_AREA_SPHERE;
    source.x = halfX.xyz;
    source.y = halfY;
    if (shape == RL_AREA_SPHERE) source.x = perpendicularTo(normalize(center)) * halfX.w;
    if (shape >= RL_AREA_SPHERE) {
        vec3 across = cross(source.x, center);
        source.y = across * (halfX.w * inversesqrt(max(dot(across, across), 1e-12)));
    }
    return source;
}
#endif

vec3 areaLight(int texel, LitSurface s, AreaFrame f) {
    vec4 a = texelFetch(lightTexels, texel);      // position, 1 / range^2
    vec4 b = texelFetch(lightTexels, texel + 1);  // luminance, shape
    vec4 c = texelFetch(lightTexels, texel + 2);  // half x, radius
    vec4 d = texelFetch(lightTexels, texel + 3);  // half y, two sided
    vec3 center = a.xyz - s.position;
    LightOutline outline;
    float facing = 1.0;
    if (b.w < float(RL_AREA_SPHERE) - 0.5) {
        outline = b.w < 0.5 ? rectangleOutline(center, c.xyz, d.xyz)
                            : diskOutline(center, c.xyz, d.xyz);
        facing = max(step(dot(cross(c.xyz, d.xyz), center), 0.0), d.w);
    } else if (b.w < float(RL_AREA_TUBE) - 0.5) {
        outline = sphereOutline(center, c.w);
    } else {
        outline = tubeOutline(center, c.xyz, c.w);
    }
    vec2 factors = outlineFormFactors(outline, f.tangent, f.bitangent, s.point.normal, f.ltc);
    float x = dot(center, center) * a.w;
    float reach = clamp(1.0 - x * x, 0.0, 1.0) * facing;
#if defined(AREA_SHADOW)
    LampShare within = LampShare(reach);
    vec4 e = texelFetch(lightTexels, texel + 4);  // shadow record, extent
    if (e.x >= 0.0 && reach > 0.0)
        within *= areaVisibility(int(e.x), s, areaSource(center, int(b.w + 0.5), c, d.xyz, e.y));
#else
    float within = reach;
#endif
    vec3 reflected =
        s.point.diffuseOverPi * (factors.x / kInversePi) + s.point.specularAlbedo * factors.y;
    return reflected * b.rgb * within;
}

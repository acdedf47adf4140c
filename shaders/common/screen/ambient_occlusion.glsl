// How much of the ambient light reaches a point of the screen, and from where: the occlusion image, half the size, brought
// to full size, with the point's own normal so that fine normal maps stay sharp.
#include "common/screen/occlusion_texel.glsl"

layout(binding = RL_TEXTURE_AMBIENT_OCCLUSION) uniform sampler2D occlusionMap;

struct AmbientVisibility {
    vec3 bent;      // unit: the mean direction of what is open
    float visible;  // cosine-weighted share of the hemisphere, 0 to 1
};

// `perDepth`: difference of device depth to a share of the distance; see ambientVisibility's callers.
// Texel (x, y) of the image was made at pixel (2x, 2y): a pixel lies on one, or between two, or between four.
AmbientVisibility ambientVisibility(vec2 fragment, float depth, float perDepth, vec3 normal) {
    ivec2 pixel = ivec2(fragment);
    ivec2 low = pixel / 2;
    ivec2 odd = pixel - low * 2;
    ivec2 high = min(low + odd, textureSize(occlusionMap, 0) - 1);
    vec4 a = texelFetch(occlusionMap, low, 0);
    vec4 b = texelFetch(occlusionMap, ivec2(high.x, low.y), 0);
    vec4 c = texelFetch(occlusionMap, ivec2(low.x, high.y), 0);
    vec4 d = texelFetch(occlusionMap, high, 0);
    vec4 depths = vec4(a.w, b.w, c.w, d.w);
    vec4 weights = 1.0 / (0.002 + abs(depths - depth) * perDepth);
    weights *= vec4(greaterThan(depths, vec4(0.0)));
    float total = dot(weights, vec4(1.0));
    float scale = 1.0 / max(total, 1e-6);
    vec3 missing =
        (a.rgb * weights.x + b.rgb * weights.y + c.rgb * weights.z + d.rgb * weights.w) * scale;
    float visible = dot(weights, vec4(occlusionVisible(a.w), occlusionVisible(b.w),
                                      occlusionVisible(c.w), occlusionVisible(d.w))) * scale;
    AmbientVisibility v;
    v.visible = total > 0.0 ? visible : 1.0;  // only background around
    vec3 open = normal * kOpenSkyLength - missing;
    open += normal * max(0.1 - dot(open, normal), 0.0);  // never far below the surface
    v.bent = normalize(open);
    return v;
}

// The share of a point or spot light that reaches a surface, from the shadow atlas. Layout: GpuShadowFace in
// renderer/frame/shadow_view.h.
#include "common/shadow_filter.glsl"

layout(binding = RL_TEXTURE_SHADOW_ATLAS) uniform SHADOW_MAP shadowAtlas;
layout(binding = RL_TEXTURE_SHADOW_FACES) uniform samplerBuffer shadowFaces;

// +x, -x, +y, -y, +z, -z
int cubeFace(vec3 p) {
    vec3 a = abs(p);
    return a.x >= a.y && a.x >= a.z ? (p.x < 0.0 ? 1 : 0)
           : a.y >= a.z             ? (p.y < 0.0 ? 3 : 2)
                                    : (p.z < 0.0 ? 5 : 4);
}

// `record`: twice the index of the light's first face; odd for a cube.
float punctualVisibility(int record, LitSurface s, vec3 towardsLight, float distance) {
    vec3 p = towardsLight * -distance;
    int texel = ((record >> 1) + ((record & 1) != 0 ? cubeFace(p) : 0)) * 4;
    vec4 right = texelFetch(shadowFaces, texel);
    vec4 up = texelFetch(shadowFaces, texel + 1);
    vec4 forward = texelFetch(shadowFaces, texel + 2);
    vec4 more = texelFetch(shadowFaces, texel + 3);
    float cosine = clamp(dot(s.point.normal, towardsLight), 0.0, 1.0);
    float texelMetres = more.y * max(dot(forward.xyz, p), 0.0);
    vec3 q = p + s.point.normal * (texelMetres * shadowOffset(cosine));
    float w = max(dot(forward.xyz, q), forward.w);  // behind a spot there is no light
    ShadowLookup at;
    at.uv = vec2(dot(right.xyz, q), dot(up.xyz, q)) / w + vec2(right.w, up.w);
    at.layer = 0.0;
    at.reference = forward.w / w;
    at.size = float(textureSize(shadowAtlas, 0).x);
#if defined(SHADOW_SOFT)
    // 1 / w of a plane is linear in the tangents u, v of the view: w (u n.right + v n.up + n.forward) = n.p
    float plane = max(distance * cosine, 0.1 * distance);
    at.slope = vec2(dot(right.xyz, s.point.normal), dot(up.xyz, s.point.normal)) *
               (-forward.w / (plane * more.z * more.z));
    at.softness = more.w / forward.w * more.z;
    at.limit = more.x;
#endif
    return filterShadow(shadowAtlas, at);
}

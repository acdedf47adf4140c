// The share of a point or spot light that reaches a surface, from the shadow atlas. Layout: GpuShadowFace in
// renderer/frame/shadow_view.h.

layout(binding = RL_TEXTURE_SHADOW_ATLAS) uniform sampler2DArray shadowAtlas;
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
    float w = max(dot(forward.xyz, p), forward.w);  // behind a spot there is no light
    // 1 / w of a plane is linear in the tangents u, v of the view: w (u n.right + v n.up + n.forward) = n.p
    float cosine = max(dot(s.facing.xyz, towardsLight), 1.0 / RL_STEEPEST_RECEIVER);
    vec2 across = vec2(dot(right.xyz, s.facing.xyz), dot(up.xyz, s.facing.xyz)) / more.z;
    ShadowLookup at;
    at.size = float(textureSize(shadowAtlas, 0).x);
    at.texelSize = 1.0 / at.size;
    at.uv = vec2(dot(right.xyz, p), dot(up.xyz, p)) / w + vec2(right.w, up.w);
    at.layer = 0.0;
    at.slope = across * (-forward.w * more.y / (distance * cosine));
    at.reference = forward.w / w * (1.0 + more.y * shadowSlack(sqrt(1.0 - cosine * cosine) / cosine, s.facing.w));
#if defined(SHADOW_SOFT)
    at.softness = more.w / (forward.w * more.y);
    at.limit = more.x;
#endif
    return filterShadow(shadowAtlas, at) * beforeTriangle(s.facing, towardsLight);
}

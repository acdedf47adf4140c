// Shadow views of lights in the atlas. Layout: GpuShadowFace in renderer/shadows/shadow_view.h.

layout(binding = RL_TEXTURE_SHADOW_FACES) uniform samplerBuffer shadowFaces;

#if defined(PUNCTUAL_SHADOW) || defined(AREA_SHADOW)

layout(binding = RL_TEXTURE_SHADOW_ATLAS) uniform sampler2DArray shadowAtlas;

// +x, -x, +y, -y, +z, -z
int cubeFace(vec3 p) {
    vec3 a = abs(p);
    return a.x >= a.y && a.x >= a.z ? (p.x < 0.0 ? 1 : 0)
           : a.y >= a.z             ? (p.y < 0.0 ? 3 : 2)
                                    : (p.z < 0.0 ? 5 : 4);
}

struct ShadowFace {
    vec4 right;  // w: u of the view's middle
    vec4 up;
    vec4 forward;  // w: near plane
    vec4 more;     // limit of a filter's reach in texels, texel and uv per tangent, radius
};

ShadowFace shadowFace(int index) {
    return ShadowFace(texelFetch(shadowFaces, index * 4), texelFetch(shadowFaces, index * 4 + 1),
                      texelFetch(shadowFaces, index * 4 + 2), texelFetch(shadowFaces, index * 4 + 3));
}

// Of a surface at `p` from the light; `cosine` between its triangle and the light.
ShadowLookup lookUpFace(ShadowFace face, LitSurface s, vec3 p, float distance, float cosine) {
    float w = max(dot(face.forward.xyz, p), face.forward.w);  // behind a spot there is no light
    // 1 / w of a plane is linear in the tangents u, v of the view: w (u n.right + v n.up + n.forward) = n.p
    vec2 across = vec2(dot(face.right.xyz, s.facing.xyz), dot(face.up.xyz, s.facing.xyz)) / face.more.z;
    ShadowLookup at;
    at.size = float(textureSize(shadowAtlas, 0).x);
    at.texelSize = 1.0 / at.size;
    at.uv = vec2(dot(face.right.xyz, p), dot(face.up.xyz, p)) / w + vec2(face.right.w, face.up.w);
    at.layer = 0.0;
    at.slope = across * (-face.forward.w * face.more.y / (distance * cosine));
    at.reference = face.forward.w / w * (1.0 + face.more.y * shadowSlack(sqrt(1.0 - cosine * cosine) / cosine, s.facing.w));
#if defined(SHADOW_SOFT)
    at.softness = face.more.w / (face.forward.w * face.more.y);
    at.limit = face.more.x;
#endif
    return at;
}

#endif

// The share of a point or spot light that reaches a surface, from the shadow atlas.

// `record`: twice the index of the light's first face; odd for a cube.
LampShare punctualVisibility(int record, LitSurface s, vec3 towardsLight, float distance) {
    vec3 p = towardsLight * -distance;
    ShadowFace face = shadowFace((record >> 1) + ((record & 1) != 0 ? cubeFace(p) : 0));
    float cosine = max(dot(s.facing.xyz, towardsLight), 1.0 / RL_STEEPEST_RECEIVER);
    ShadowLookup at = lookUpFace(face, s, p, distance, cosine);
    float lit = filterShadow(shadowAtlas, at) * beforeTriangle(s.facing, towardsLight);
#if defined(ATLAS_GLASS)
    return lit * filterGlass(atlasGlass, at, false);
#else
    return lit;
#endif
}

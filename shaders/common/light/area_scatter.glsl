// Light of area lights that a piece of a froxel scatters to the eye: their luminance times the solid angle that they fill,
// under the phase function's value for their middle.

vec3 areaScattering(int texel, LitSurface s, Piece piece) {
    vec4 a = texelFetch(lightTexels, texel);  // as areaLight reads them
    vec4 b = texelFetch(lightTexels, texel + 1);
    vec4 c = texelFetch(lightTexels, texel + 2);
    vec4 d = texelFetch(lightTexels, texel + 3);
    int shape = int(b.w + 0.5);
    vec3 center = a.xyz - s.position;
    float distance2 = max(dot(center, center), 1e-8);
    float angle, size2;
    if (shape == RL_AREA_SPHERE) {
        angle = ballSolidAngle(distance2, c.w);
        size2 = c.w * c.w;
    } else if (shape == RL_AREA_TUBE) {
        angle = outlineSolidAngle(tubeOutline(center, c.xyz, c.w));
        size2 = c.w * length(c.xyz);
    } else {
        angle = outlineSolidAngle(shape == RL_AREA_DISK ? diskOutline(center, c.xyz, d.xyz)
                                                        : rectangleOutline(center, c.xyz, d.xyz));
        angle *= max(step(dot(cross(c.xyz, d.xyz), center), 0.0), d.w);
        size2 = length(c.xyz) * length(d.xyz);
    }
    vec3 towards = center * inversesqrt(distance2);
    float x = distance2 * a.w;
    float reach = clamp(1.0 - x * x, 0.0, 1.0);
#if defined(AREA_SHADOW)
    LampShare within = LampShare(reach);
    vec4 e = texelFetch(lightTexels, texel + 4);
    if (e.x >= 0.0 && reach * angle > 0.0) {
        s.facing = vec4(towards, 0.0);
        within *= areaVisibility(int(e.x), s, areaSource(center, shape, c, d.xyz, e.y));
    }
#else
    float within = reach;
#endif
    // From near a small light the angle changes along the piece as a lamp's attenuation does; see lampScattering.
    float along = -dot(towards, s.point.view) * sqrt(distance2);
    float away = sqrt(max(distance2 - along * along, 0.0) + piece.width * piece.width + size2);
    float mean = (atan((piece.halfLength - along) / away) + atan((piece.halfLength + along) / away)) /
                 (2.0 * piece.halfLength * away);
    return b.rgb * (angle * (distance2 + size2) * mean * within * phase(-dot(towards, s.point.view)));
}

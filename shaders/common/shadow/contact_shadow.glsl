// What hides a light within a short way of a surface, as far as the depth buffer shows it: detail that is finer than the
// shadow map's texels. A march along the ray towards the light; steps begin at a fixed pattern of pixels.
//
// A texel hides the ray where it is before it, by less than 0.15 of the ray's length (how thick it is is not known), and
// stands clear of the surface's own plane. Its place is worked out at its own centre, not where the ray is: texels of the
// plane itself are then exactly in it, however grazing the view, and never shadow it.
#define CONTACT_STEPS 16

/// How the picture lies in space at a pixel. A relative position at a view depth is base + ray * depth; with them go changes
/// per pixel to the right (X) and up (Y). A metre along a direction d is pixels times view depth (pixels, if the view is
/// orthographic) of dot(d, across) and dot(d, up), and dot(d, L_VIEW_DIRECTION) of view depth.
struct ContactScreen {
    vec3 rayX, rayY, baseX, baseY;
    vec3 across, up;
};

ContactScreen contactScreen() {
    ContactScreen r;
    r.rayX = dFdx(pixelRay);
    r.rayY = dFdy(pixelRay);
    r.baseX = dFdx(pixelBase);
    r.baseY = dFdy(pixelBase);
#if defined(ORTHOGRAPHIC)
    r.across = r.baseX / dot(r.baseX, r.baseX);
    r.up = r.baseY / dot(r.baseY, r.baseY);
#else
    // The ray at pixel 0 is pixelRay - rayX * x - rayY * y; what it turns to the side is not the direction's.
    vec3 across = r.rayX / dot(r.rayX, r.rayX), up = r.rayY / dot(r.rayY, r.rayY);
    r.across = across + L_VIEW_DIRECTION * (gl_FragCoord.x - dot(pixelRay, across));
    r.up = up + L_VIEW_DIRECTION * (gl_FragCoord.y - dot(pixelRay, up));
#endif
    return r;
}

float contactVisibility(LitSurface s, ContactScreen screen, vec3 towardsLight, float reach) {
    vec3 along = vec3(dot(towardsLight, screen.across), dot(towardsLight, screen.up),
                      dot(towardsLight, L_VIEW_DIRECTION));
    float rise = dot(s.facing.xyz, towardsLight);
    float pixel = length(screen.baseX + screen.rayX * s.viewDepth);
    // Jimenez 2014, "Next Generation Post Processing in Call of Duty": interleaved gradient noise
    float offset = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    // A guessed plane (LitSurface::facing) is further off the further the ray goes.
    float clear = rise * (s.facing.w > 0.5 ? 0.75 : 0.25);
    vec2 last = vec2(textureSize(depthMap, 0) - 1);
    float hidden = 0.0;
    if (rise <= 0.0) return 1.0;
    for (int i = 0; i < CONTACT_STEPS; ++i) {
        float way = reach * (float(i) + offset) * (1.0 / float(CONTACT_STEPS));
        float depth = s.viewDepth + along.z * way;
#if defined(ORTHOGRAPHIC)
        vec2 place = gl_FragCoord.xy + along.xy * way;
#else
        vec2 place = (gl_FragCoord.xy * s.viewDepth + along.xy * way) / max(depth, 1e-4);
#endif
        vec2 texel = clamp(floor(place), vec2(0.0), last);
        float linear = texelFetch(depthMap, ivec2(texel), 0).x * flatDepthDecode.x + flatDepthDecode.y;
#if defined(ORTHOGRAPHIC)
        float there = linear;
#else
        float there = 1.0 / max(linear, 1e-9);
#endif
        vec2 d = texel + 0.5 - gl_FragCoord.xy;
        vec3 from = pixelBase + screen.baseX * d.x + screen.baseY * d.y +
                    (pixelRay + screen.rayX * d.x + screen.rayY * d.y) * there - s.position;
        float before = depth - there;
        bool hides = before > 0.0 && before < 0.15 * reach && all(equal(texel, floor(place))) &&
                     dot(from, s.facing.xyz) > 0.5 * pixel + clear * way;
        if (hides) hidden = max(hidden, min(3.0 - 3.0 * way / reach, 1.0));
    }
    return 1.0 - hidden;
}

// What hides the first sun within a short way of a surface, as far as the depth buffer shows it: detail that is finer than
// the shadow map's texels. A march along the ray towards the sun; steps begin at a fixed pattern of pixels.
//
// A texel hides the ray where it is before it, by less than 0.15 of the ray's length (how thick it is is not known), and
// stands clear of the surface's own plane. Its place is worked out at its own centre, not where the ray is: texels of the
// plane itself are then exactly in it, however grazing the view, and never shadow it.
#define CONTACT_STEPS 16

/// L_CONTACT_RAY: xy: pixels times view depth (pixels, if the view is orthographic) a metre, z: view depth a metre.
float contactVisibility(LitSurface s, vec3 towardsLight) {
    vec3 rayX = dFdx(pixelRay), rayY = dFdy(pixelRay);
    vec3 baseX = dFdx(pixelBase), baseY = dFdy(pixelBase);
    float rise = dot(s.facing.xyz, towardsLight);
    float reach = L_CONTACT_LENGTH;
    float pixel = length(baseX + rayX * s.viewDepth);
    // Jimenez 2014, "Next Generation Post Processing in Call of Duty": interleaved gradient noise
    float offset = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    // A guessed plane (LitSurface::facing) is further off the further the ray goes.
    float clear = rise * (s.facing.w > 0.5 ? 0.75 : 0.25);
    vec2 last = vec2(textureSize(depthMap, 0) - 1);
    float hidden = 0.0;
    if (rise <= 0.0) return 1.0;
    for (int i = 0; i < CONTACT_STEPS; ++i) {
        float way = reach * (float(i) + offset) * (1.0 / float(CONTACT_STEPS));
        float depth = s.viewDepth + L_CONTACT_RAY.z * way;
#if defined(ORTHOGRAPHIC)
        vec2 place = gl_FragCoord.xy + L_CONTACT_RAY.xy * way;
#else
        vec2 place = (gl_FragCoord.xy * s.viewDepth + L_CONTACT_RAY.xy * way) / max(depth, 1e-4);
#endif
        vec2 texel = clamp(floor(place), vec2(0.0), last);
        float linear = texelFetch(depthMap, ivec2(texel), 0).x * flatDepthDecode.x + flatDepthDecode.y;
#if defined(ORTHOGRAPHIC)
        float there = linear;
#else
        float there = 1.0 / max(linear, 1e-9);
#endif
        vec2 d = texel + 0.5 - gl_FragCoord.xy;
        vec3 from = pixelBase + baseX * d.x + baseY * d.y + (pixelRay + rayX * d.x + rayY * d.y) * there - s.position;
        float before = depth - there;
        bool hides = before > 0.0 && before < 0.15 * reach && all(equal(texel, floor(place))) &&
                     dot(from, s.facing.xyz) > 0.5 * pixel + clear * way;
        if (hides) hidden = max(hidden, min(3.0 - 3.0 * way / reach, 1.0));
    }
    return 1.0 - hidden;
}

// The lit radiance taken apart: what PART_... names. Direct + ambient * share + emission is the whole; an unlit surface is
// emission alone.
vec3 lightingPart(LitSurface s, vec2 pixel, vec3 emission, bool unlit) {
#if defined(PART_EMISSION)
    return unlit ? s.baseColor : emission;
#elif defined(PART_DIRECT)
    vec3 direct = directionalLight(s);
#if defined(CLUSTERED_LIGHTS)
    direct += clusteredLight(s, pixel);
#endif
    return unlit ? vec3(0.0) : direct;
#elif defined(PART_UNTEXTURED)
    return unlit ? vec3(0.0) : lightSurface(s, pixel);
#else
    LitSurface open = s;
    open.occlusion = 1.0;
    open.visible = 1.0;
    open.bent = s.point.normal;
    vec3 ambient = unlit ? vec3(0.0) : ambientLight(open);
#if defined(PART_AMBIENT_SHARE)
    // What is left may be more: the bent normal can look at a brighter side. Black stays black.
    return min(ambientLight(s) / max(ambient, 1e-6), 1e4);
#else
    return ambient;
#endif
#endif
}

// Which way a pixel's triangle faces, from the depths around it: for what only the G-buffer knows.

// Where the pixel beside lies, by its ray and depth.
vec3 positionBeside(vec3 ray, float depth) {
    float linear = depth * flatDepthDecode.x + flatDepthDecode.y;
#if defined(ORTHOGRAPHIC)
    return pixelRay * linear + ray;
#else
    return pixelBase + ray / linear;
#endif
}

// Along each axis that neighbour counts which is nearer in depth: it is on the surface where another one begins at the
// other side. Within a block of 2x2 a pixel cannot tell, and seen at a grazing angle the step to what is behind looks much
// like the surface itself. As facingOf.
vec4 facingOfDepths(vec3 position, float depth, vec3 normal) {
    vec2 size = vec2(textureSize(depthMap, 0));
    vec2 texel = gl_FragCoord.xy / size, one = 1.0 / size;
    vec4 low = textureGather(depthMap, texel - 0.5 * one);   // x: left, y: this, z: below's right is this column
    vec4 high = textureGather(depthMap, texel + 0.5 * one);
    // Order of textureGather: (0,1) (1,1) (1,0) (0,0).
    float left = low.x, below = low.z, right = high.z, above = high.x;
    bool toLeft = abs(left - depth) < abs(right - depth);
    bool toBelow = abs(below - depth) < abs(above - depth);
    toLeft = gl_FragCoord.x + 1.0 > size.x || (toLeft && gl_FragCoord.x > 1.0);
    toBelow = gl_FragCoord.y + 1.0 > size.y || (toBelow && gl_FragCoord.y > 1.0);
#if defined(ORTHOGRAPHIC)
    vec3 stepX = dFdx(pixelBase), stepY = dFdy(pixelBase), ray = pixelBase;
#else
    vec3 stepX = dFdx(pixelRay), stepY = dFdy(pixelRay), ray = pixelRay;
#endif
    vec3 x = toLeft ? position - positionBeside(ray - stepX, left) : positionBeside(ray + stepX, right) - position;
    vec3 y = toBelow ? position - positionBeside(ray - stepY, below) : positionBeside(ray + stepY, above) - position;
    vec3 across = cross(x, y);
    float inverse = inversesqrt(max(dot(across, across), 1e-30));
    float along = dot(across, normal) * inverse;
    // Depths of a plane are linear in the picture: where they bend, the pixel is narrower than what its neighbours show
    // (a sill, a bevel), and they say nothing of it.
    vec2 bend = abs(vec2(left + right, below + above) - 2.0 * depth);
    bool isNarrow = any(greaterThan(bend, abs(vec2(right - left, above - below)) + 4e-7 * depth));
    return abs(along) > 0.9 && !isNarrow ? vec4(across * (along < 0.0 ? -inverse : inverse), 0.0) : vec4(normal, 1.0);
}

// Depths of what light first goes through, in the alpha of RGBA16F: 0 where there is nothing. Half floats are as exact
// everywhere in their logarithm: a lamp's depth is near / distance and is kept as it is, a sun's is linear.

const float kGlassOctaves = 14.0;  // that normal half floats have below 1

float encodeGlassDepth(float depth, bool parallel) {
    return parallel ? exp2(kGlassOctaves * (clamp(depth, 0.0, 1.0) - 1.0)) : depth;
}

// Below 0 where there is nothing of a sun's.
vec4 decodeGlassDepths(vec4 kept, bool parallel) {
    return parallel ? log2(max(kept, vec4(1e-9))) * (1.0 / kGlassOctaves) + 1.0 : kept;
}

// What a depth must be above to be before `plane` for sure: twice what rounding may add.
vec4 beforePlane(vec4 plane, bool parallel) {
    return parallel ? plane + 1e-4 : max(plane, 0.0) * (1.0 + 1.0 / 1024.0);
}

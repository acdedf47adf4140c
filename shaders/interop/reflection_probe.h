// How reflection probes are weighed and looked up, for the shaders and for the CPU. A probe holds
// the light around the place where it was captured, and stands for what is within a box.
//
// Sources: Lagarde and Zanuttini 2012, "Local Image-based Lighting with Parallax-corrected Cubemap"
// (the mirrored ray is followed to the box, and the cube is looked up from where it was captured to
// there).
//
// The records, in a buffer of vec4: one that holds the number of probes in x, then for each probe,
// smaller boxes first:
//
//     texel 0-2   rows that take a position relative to the camera into the box, whose sides are at
//     -1 and 1 texel 3     xyz: where it was captured, relative to the camera; w: its cube in the
//     array texel 4     xyz: see ReflectionRamp::scale; w: the factor on its light texel 5     xyz:
//     see ReflectionRamp::offset
#ifndef RL_INTEROP_REFLECTION_PROBE_H
#define RL_INTEROP_REFLECTION_PROBE_H

#include "interop/interop.h"

RL_INTEROP_BEGIN

#define RL_REFLECTION_TEXELS 6

/// Metres beyond its sides at which a box ends: what lies on a wall of a room is in it.
RL_CONST float kReflectionSkin = 0.02f;

/// Along each axis a probe's influence is clamp((1 - |place|) * scale + offset, 0, 1).
struct ReflectionRamp {
    vec3 scale;
    vec3 offset;
};

/// `halfSize`: metres; `blend`: metres within the sides over which the influence rises.
RL_INLINE ReflectionRamp reflectionRamp(vec3 halfSize, vec3 blend) {
    vec3 width = max(blend, vec3(kReflectionSkin));
    ReflectionRamp ramp;
    ramp.scale = halfSize / width;
    ramp.offset = vec3(kReflectionSkin) / width;
    return ramp;
}

/// `place`: in the box, -1 to 1 along each axis.
RL_INLINE float reflectionInfluence(vec3 place, vec3 scale, vec3 offset) {
    vec3 ramp = (vec3(1.0f) - abs(place)) * scale + offset;
    return clamp(min(ramp.x, min(ramp.y, ramp.z)), 0.0f, 1.0f);
}

/// How far along a ray the box ends, in lengths of the ray's direction; both in the box's own
/// units.
RL_INLINE float distanceToBox(vec3 place, vec3 direction) {
    vec3 from = clamp(place, vec3(-1.0f), vec3(1.0f));
    vec3 along = max(abs(direction), vec3(1e-6f));
    vec3 mirrored = vec3(direction.x < 0.0f ? -from.x : from.x,
                         direction.y < 0.0f ? -from.y : from.y,
                         direction.z < 0.0f ? -from.z : from.z);
    vec3 distances = (vec3(1.0f) - mirrored) / along;
    return min(distances.x, min(distances.y, distances.z));
}

RL_INTEROP_END

#endif

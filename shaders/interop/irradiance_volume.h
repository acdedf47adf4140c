// How a grid of irradiance probes is looked up, for the shaders and for the CPU. A probe keeps, for
// each colour, the mean of the radiance around it and the mean of radiance times direction; and how
// far it sees in each direction.
//
// Sources: Majercik, Guertin, Nowrouzezahrai, McGuire 2019, "Dynamic Diffuse Global Illumination
// with Ray-Traced Irradiance Fields", JCGT 8(2) (visibility by depth moments, wrapped cosine,
// weights near zero pressed down); Hazel 2015, "Reconstructing Diffuse Lighting from Spherical
// Harmonic Data" (irradiance from two bands, never negative); Kuhn 1960, "Some Combinatorial Lemmas
// in Topology" (a cube as six tetrahedra: four probes, not eight).
//
// A probe's record, two texels of 4 x uint32, each two halves:
//
//     texel 0   x: mean r, g           y: mean b, flow r.x    z: flow r.y, r.z    w: flow g.x, g.y
//     texel 1   x: flow g.z, flow b.x  y: flow b.y, b.z       z: offset x, y      w: offset z,
//     weight
//
// offset: metres from its grid point; weight: 1, or next to nothing where a probe is in a wall and
// was filled from its neighbours. Distances: a square of RL_PROBE_TEXELS a side by octahedral
// direction with one texel of border; x: mean, y: standard deviation in metres.
#ifndef RL_INTEROP_IRRADIANCE_VOLUME_H
#define RL_INTEROP_IRRADIANCE_VOLUME_H

#include "interop/encode.h"
#include "interop/interop.h"

RL_INTEROP_BEGIN

#define RL_PROBE_RECORD_TEXELS 2
#define RL_PROBE_TEXELS 16
#define RL_PROBE_TILE 18
// The distance atlas holds this many probes in a row.
#define RL_PROBE_ATLAS_ROW 256

/// Points are moved off their surface by this share of the smallest spacing before a probe is asked
/// whether it sees them.
RL_CONST float kProbeNormalBias = 0.2f;
/// And by this share of that towards the eye: in a corner the normal leads along the other surface,
/// the way to the eye off it.
RL_CONST float kProbeEyeBias = 0.75f;
/// The weight of probes that were filled from others.
RL_CONST float kFilledProbeWeight = 1e-4f;

/// Four probes around a point and their shares, which add up to one.
struct ProbeCorners {
    vec3 second;  ///< from the first probe's grid place; 0 or 1 along each axis. The first is (0,
                  ///< 0, 0),
    vec3 third;   ///< the fourth (1, 1, 1).
    vec4 shares;
};

/// `f`: the place within the cell, 0 to 1 along each axis. The tetrahedron follows the order of f's
/// components.
RL_INLINE ProbeCorners probeCorners(vec3 f) {
    ProbeCorners c;
    float largest = max(f.x, max(f.y, f.z));
    float smallest = min(f.x, min(f.y, f.z));
    float middle = f.x + f.y + f.z - largest - smallest;
    // Of equal components exactly one is the largest and one the smallest.
    float bigX = f.x >= f.y && f.x >= f.z ? 1.0f : 0.0f;
    float bigY = bigX == 0.0f && f.y >= f.z ? 1.0f : 0.0f;
    float smallZ = f.z <= f.x && f.z <= f.y && bigX + bigY > 0.0f ? 1.0f : 0.0f;
    float smallY = smallZ == 0.0f && f.y <= f.x && bigY == 0.0f ? 1.0f : 0.0f;
    c.second = vec3(bigX, bigY, 1.0f - bigX - bigY);
    c.third = vec3(smallZ + smallY, 1.0f - smallY, 1.0f - smallZ);
    c.shares = vec4(1.0f - largest, largest - middle, middle - smallest, smallest);
    return c;
}

/// Share of one of the cell's corners, linear along each axis.
RL_INLINE float cornerShare(vec3 f, vec3 corner) {
    vec3 s = mix(vec3(1.0f) - f, f, corner);
    return s.x * s.y * s.z;
}

/// How much all eight probes of the cell count beside the tetrahedron's, which in corners of rooms
/// may not see the point. `seen`: what those weigh together, about 0.2 to 1 on open surfaces.
RL_INLINE float probeDoubt(float seen) {
    float doubt = clamp(1.0f - seen * 10.0f, 0.0f, 1.0f);
    return doubt * doubt * (3.0f - 2.0f * doubt);
}

/// A probe's weight beside its share. `toProbe`: from the surface point; `toPoint`: from the probe
/// to the point moved off the surface; `seen`: mean and deviation of the distance that the probe
/// sees that way.
RL_INLINE float probeVisibility(vec3 normal, vec3 toProbe, float distance, vec2 seen) {
    float facing = dot(toProbe, normal) * inversesqrt(max(dot(toProbe, toProbe), 1e-8f));
    float wrapped = facing * 0.5f + 0.5f;
    // Most of the deviation is the slant of surfaces within a texel: the nearer of them hide, and
    // sharply.
    float beyond = max(distance - (seen.x - seen.y), 0.0f);
    float deviation = 0.5f * seen.y + 0.02f * distance;
    float variance = deviation * deviation;
    float chebyshev = variance / max(variance + beyond * beyond, 1e-8f);
    chebyshev = beyond > 0.0f ? chebyshev * chebyshev * chebyshev : 1.0f;
    float weight = (wrapped * wrapped + 0.05f) * max(chebyshev, 1e-3f);
    // What is nearly hidden counts for less than it would, with no edge where that begins.
    return weight < 0.2f ? weight * weight * weight * 25.0f : weight;
}

/// Irradiance over pi of one colour at a normal, over its mean radiance. `direction`: flow over
/// mean; length up to 1. Two bands are exactly 1 + 2 direction.n, which is also the light of an
/// even half of the sphere (length 1/2); for more directed light that would be negative behind, and
/// one lobe of the same mean takes over, up to the 4 of light from one direction (the idea: Hazel
/// 2015).
RL_INLINE float irradianceShape(vec3 direction, vec3 normal) {
    float r = length(direction);
    float along = dot(direction, normal);
    float q = 0.5f + 0.5f * along / max(r, 1e-6f);
    float p = clamp(4.0f * r - 1.0f, 1.0f, 3.0f);
    float lobe = (p + 1.0f) * pow(clamp(q, 1e-6f, 1.0f), p);
    return r <= 0.5f ? 1.0f + 2.0f * along : lobe;
}

/// How much a volume counts at `grid`, in cells from its first probe: 1 within half a cell of the
/// grid, 0 a cell out.
RL_INLINE float volumeFade(vec3 grid, vec3 lastProbe) {
    vec3 out3 = max(max(vec3(0.0f) - grid, grid - lastProbe), vec3(0.0f));
    float farthest = max(out3.x, max(out3.y, out3.z));
    return clamp(2.0f - 2.0f * farthest, 0.0f, 1.0f);
}

RL_INTEROP_END

#endif

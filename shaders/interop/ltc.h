// Light from surfaces of one luminance: linearly transformed cosines, for shaders and for tests on
// the CPU.
//
// Sources: Heitz, Dupuy, Hill, Neubelt 2016, "Real-Time Polygonal-Light Shading with Linearly
// Transformed Cosines"; Heitz and Hill 2017, "Real-Time Line- and Disk-Light Shading with Linearly
// Transformed Cosines"; Lambert 1760 (the irradiance of a polygon as a sum over its edges).
//
// Everything that shines is an outline, seen from the lit point: as luminance is the same in all
// directions, only the solid angle that it fills counts. A disk is its ellipse, a sphere the disk
// that its tangent cone cuts, a tube (with closed ends) two lines and two arcs. Round outlines are
// polygons of the same area.
#ifndef RL_INTEROP_LTC_H
#define RL_INTEROP_LTC_H

#include "interop/brdf.h"

RL_INTEROP_BEGIN

RL_CONST float kTwoPi = 6.283185307179586f;
#define RL_AREA_RECTANGLE 0
#define RL_AREA_DISK 1
#define RL_AREA_SPHERE 2
#define RL_AREA_TUBE 3
// Corners of a round outline; even.
#define RL_OUTLINE_CORNERS 16
// Texels along a side of the table of matrices: columns sqrt(1 - n.v), rows perceptual roughness;
// the outermost texels' centres are 0 and 1.
#define RL_LTC_TABLE_SIZE 32

/// Corner i is at center + x cos(angle) + y sin(angle), angle = first + i step; the second half has
/// its own center and angles.
struct LightOutline {
    vec3 center0;
    vec3 center1;
    vec3 x;
    vec3 y;
    vec2 angles0;  ///< x: first, y: step
    vec2 angles1;
    int corners;
};

RL_INLINE vec3 outlineCorner(LightOutline o, int i) {
    int halfway = o.corners / 2;
    bool second = i >= halfway;
    float angle = second ? o.angles1.x + o.angles1.y * float(i - halfway)
                         : o.angles0.x + o.angles0.y * float(i);
    vec3 center = second ? o.center1 : o.center0;
    return center + o.x * cos(angle) + o.y * sin(angle);
}

RL_INLINE LightOutline ellipseOutline(vec3 center, vec3 halfX, vec3 halfY, int corners) {
    LightOutline o;
    o.center0 = center;
    o.center1 = center;
    o.x = halfX;
    o.y = halfY;
    float step = kTwoPi / float(corners);
    o.angles0 = vec2(0.0f, step);
    o.angles1 = vec2(step * float(corners / 2), step);
    o.corners = corners;
    return o;
}

/// `center` and the half sides are relative to the lit point.
RL_INLINE LightOutline rectangleOutline(vec3 center, vec3 halfX, vec3 halfY) {
    return ellipseOutline(center, halfX + halfY, halfY - halfX, 4);
}

// A polygon of n corners within an ellipse has n / (2 pi) sin(2 pi / n) of its area.
RL_INLINE LightOutline diskOutline(vec3 center, vec3 halfX, vec3 halfY) {
    float step = kTwoPi / float(RL_OUTLINE_CORNERS);
    float wider = sqrt(step / sin(step));
    return ellipseOutline(center, halfX * wider, halfY * wider, RL_OUTLINE_CORNERS);
}

/// A unit vector at right angles to `n`. Duff et al. 2017, "Building an Orthonormal Basis,
/// Revisited".
RL_INLINE vec3 perpendicularTo(vec3 n) {
    float s = n.z >= 0.0f ? 1.0f : -1.0f;
    float a = -1.0f / (s + n.z);
    return vec3(1.0f + s * n.x * n.x * a, s * n.x * n.y * a, -s * n.x);
}

RL_INLINE LightOutline sphereOutline(vec3 center, float radius) {
    float distance2 = max(dot(center, center), radius * radius * 1.0002f);
    vec3 towards = normalize(center);
    vec3 side = perpendicularTo(towards);
    float share = radius * radius / distance2;
    float seen = radius * sqrt(1.0f - share);
    return diskOutline(center * (1.0f - share), side * seen, cross(towards, side) * seen);
}

/// A cylinder with closed ends around center +- half.
RL_INLINE LightOutline tubeOutline(vec3 center, vec3 along, float radius) {
    float halfLength = max(length(along), 1e-6f);
    vec3 axis = along * (1.0f / halfLength);
    float axial = dot(center, axis);
    vec3 across = center - axis * axial;
    float distance = max(length(across), radius * 1.0001f);
    vec3 away = length(across) > 1e-6f ? normalize(across) : perpendicularTo(axis);
    // Angles are from the line of the surface that is nearest to the point; the tangents touch at
    // +-beta.
    float cosine = radius / distance;
    float beta = acos(cosine);
    LightOutline o;
    o.center0 = center + axis * halfLength;
    o.center1 = center - axis * halfLength;
    o.x = away * -radius;
    o.y = cross(axis, away) * radius;
    o.corners = RL_OUTLINE_CORNERS;
    // An end whose cap is seen is bounded by the far arc, else by the near one.
    float gaps = float(RL_OUTLINE_CORNERS / 2 - 1);
    bool cap0 = axial + halfLength < 0.0f;
    bool cap1 = axial - halfLength > 0.0f;
    float span0 = cap0 ? kTwoPi - 2.0f * beta : -2.0f * beta;
    float span1 = cap1 ? 2.0f * beta - kTwoPi : 2.0f * beta;
    o.angles0 = vec2(beta, span0 / gaps);
    o.angles1 = vec2(-beta, span1 / gaps);
    return o;
}

// ---- the irradiance of an outline
// --------------------------------------------------------------------------------

/// The sum over edges of what is above the horizon, and where the outline crosses it. A convex
/// outline leaves and comes back once; the edge between closes it.
struct HorizonSum {
    float sum;
    float crossed;
    vec3 leaves;
    vec3 returns;
};

RL_INLINE HorizonSum emptyHorizonSum() {
    HorizonSum s;
    s.sum = 0.0f;
    s.crossed = 0.0f;
    s.leaves = vec3(0.0f);
    s.returns = vec3(0.0f);
    return s;
}

/// The angle between unit vectors over its sine, by its cosine and the square of its sine, which
/// near half a turn is more exact than what the cosine gives. A rational fit of acos(x) / sqrt(1 -
/// x^2) on [0, 1], off by at most 1.4e-6 of it; on the other half it is pi / sine less its mirror
/// image.
RL_INLINE float angleOverSine(float cosine, float sine2) {
    float x = abs(cosine);
    float p = 1.57079422f + x * (0.90282977f + x * 0.025808355f);
    float q = 1.0f + x * (1.21132553f + x * 0.28810441f);
    float v = p / q;
    return cosine >= 0.0f ? v : 3.14159265f * inversesqrt(max(sine2, 1e-14f)) - v;
}

/// Lambert's term of the edge from a to b in the direction z.
RL_INLINE float edgeIrradiance(vec3 a, vec3 b) {
    vec3 u = normalize(a);
    vec3 v = normalize(b);
    vec3 across = cross(u, v);
    return angleOverSine(clamp(dot(u, v), -1.0f, 1.0f), dot(across, across)) * across.z;
}

RL_INLINE void addEdge(RL_INOUT(HorizonSum) s, vec3 a, vec3 b) {
    bool aboveA = a.z > 0.0f;
    bool aboveB = b.z > 0.0f;
    if (!aboveA && !aboveB) return;
    if (aboveA != aboveB) {
        vec3 crossing = a + (b - a) * (a.z / (a.z - b.z));
        crossing.z = 0.0f;
        s.crossed = 1.0f;
        if (aboveA) {
            s.leaves = crossing;
            b = crossing;
        } else {
            s.returns = crossing;
            a = crossing;
        }
    }
    s.sum += edgeIrradiance(a, b);
}

/// Of the hemisphere under a cosine: 1 is light from everywhere.
RL_INLINE float formFactor(HorizonSum s) {
    float sum = s.sum;
    if (s.crossed > 0.5f) sum += edgeIrradiance(s.leaves, s.returns);
    return abs(sum) * (1.0f / kTwoPi);
}

/// Steradians that an outline fills, seen from all around: a fan of triangles (Van Oosterom and
/// Strackee 1983, "The Solid Angle of a Plane Triangle").
RL_INLINE float outlineSolidAngle(LightOutline o) {
    vec3 first = normalize(outlineCorner(o, 0));
    vec3 last = normalize(outlineCorner(o, 1));
    float sum = 0.0f;
    for (int i = 2; i < o.corners; ++i) {
        vec3 next = normalize(outlineCorner(o, i));
        float volume = dot(first, cross(last, next));
        sum += 2.0f * atan(volume, 1.0f + dot(first, last) + dot(last, next) + dot(next, first));
        last = next;
    }
    return abs(sum);
}

/// Of a ball; half of all around from within.
RL_INLINE float ballSolidAngle(float distance2, float radius) {
    float share = min(radius * radius / distance2, 1.0f);
    // 1 - sqrt(1 - share), exact for small ones
    return kTwoPi * share / (1.0f + sqrt(1.0f - share));
}

// ---- the lobe
// ----------------------------------------------------------------------------------------------------

/// The inverse of the matrix that turns a cosine into the specular lobe, of unit scale in y:
/// [ m.x 0 m.y ; 0 1 0 ; m.z 0 m.w ], in the frame whose x-z plane holds the view and whose z is
/// the normal.
RL_INLINE vec3 applyLtc(vec4 m, vec3 v) {
    return vec3(m.x * v.x + m.y * v.z, v.y, m.z * v.x + m.w * v.z);
}

/// Where (nDotV, roughness) is in the table of matrices, in texture coordinates.
RL_INLINE vec2 ltcCoordinates(float nDotV, float roughness) {
    float size = float(RL_LTC_TABLE_SIZE);
    vec2 place = vec2(sqrt(clamp(1.0f - nDotV, 0.0f, 1.0f)), clampRoughness(roughness));
    return place * ((size - 1.0f) / size) + vec2(0.5f / size);
}

/// x: the share of the hemisphere that an outline fills as the diffuse lobe weighs it, y: as the
/// specular lobe does. `tangent`, `bitangent`, `normal` are the frame of applyLtc.
RL_INLINE vec2 outlineFormFactors(LightOutline o, vec3 tangent, vec3 bitangent, vec3 normal,
                                  vec4 ltc) {
    HorizonSum diffuse = emptyHorizonSum();
    HorizonSum specular = emptyHorizonSum();
    vec3 corner = outlineCorner(o, o.corners - 1);
    vec3 last = vec3(dot(corner, tangent), dot(corner, bitangent), dot(corner, normal));
    for (int i = 0; i < o.corners; ++i) {
        corner = outlineCorner(o, i);
        vec3 next = vec3(dot(corner, tangent), dot(corner, bitangent), dot(corner, normal));
        bool aboveA = last.z > 0.0f;
        bool aboveB = next.z > 0.0f;
        if (aboveA || aboveB) {
            // What is below the surface's own horizon lights neither lobe.
            vec3 crossing = last + (next - last) * (last.z / (last.z - next.z));
            crossing.z = 0.0f;
            vec3 a = aboveA ? last : crossing;
            vec3 b = aboveB ? next : crossing;
            if (aboveA != aboveB) {
                diffuse.crossed = 1.0f;
                if (aboveA)
                    diffuse.leaves = crossing;
                else
                    diffuse.returns = crossing;
            }
            diffuse.sum += edgeIrradiance(a, b);
            addEdge(specular, applyLtc(ltc, a), applyLtc(ltc, b));
        }
        last = next;
    }
    if (diffuse.crossed > 0.5f)
        addEdge(specular, applyLtc(ltc, diffuse.leaves), applyLtc(ltc, diffuse.returns));
    return vec2(formFactor(diffuse), formFactor(specular));
}

RL_INTEROP_END

#endif

#pragma once
// Closest points between simple shapes, after chapter 5.1 of Ericson, "Real-Time Collision
// Detection", 2005.

#include "engine/core/math.h"

namespace rushlight {

struct Segment {
    vec3 start, end;
};

/// A point on each of two shapes, as near to each other as any.
struct ClosestPoints {
    vec3 first{0};
    vec3 second{0};
    float distanceSquared = 0;
};

vec3 closestPointOnSegment(const Segment& segment, const vec3& point);
vec3 closestPointOnTriangle(const vec3& a, const vec3& b, const vec3& c, const vec3& point);
ClosestPoints closestPoints(const Segment& first, const Segment& second);

/// `first` is on the segment, `second` on the triangle. Zero apart when the segment goes through
/// the triangle.
ClosestPoints closestPoints(const Segment& segment, const vec3& a, const vec3& b, const vec3& c);

}  // namespace rushlight

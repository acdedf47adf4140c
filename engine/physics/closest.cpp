#include "engine/physics/closest.h"

#include <algorithm>

namespace rushlight {
namespace {

ClosestPoints between(const vec3& first, const vec3& second) {
    const vec3 apart = second - first;
    return {first, second, glm::dot(apart, apart)};
}

void keepNearer(ClosestPoints& best, const ClosestPoints& candidate) {
    if (candidate.distanceSquared < best.distanceSquared) best = candidate;
}

/// Is a point of the triangle's plane inside of all three edges?
bool isInside(const vec3& a, const vec3& b, const vec3& c, const vec3& normal, const vec3& p) {
    return glm::dot(glm::cross(b - a, p - a), normal) >= 0 &&
           glm::dot(glm::cross(c - b, p - b), normal) >= 0 &&
           glm::dot(glm::cross(a - c, p - c), normal) >= 0;
}

float clampedRatio(float numerator, float denominator) {
    return denominator > 0 ? std::clamp(numerator / denominator, 0.0f, 1.0f) : 0.0f;
}

}  // namespace

vec3 closestPointOnSegment(const Segment& segment, const vec3& point) {
    const vec3 along = segment.end - segment.start;
    return segment.start +
           along * clampedRatio(glm::dot(point - segment.start, along), glm::dot(along, along));
}

vec3 closestPointOnTriangle(const vec3& a, const vec3& b, const vec3& c, const vec3& point) {
    const vec3 normal = glm::cross(b - a, c - a);
    const float size = glm::dot(normal, normal);
    if (size > 0) {
        const vec3 onPlane = point - normal * (glm::dot(point - a, normal) / size);
        if (isInside(a, b, c, normal, onPlane)) return onPlane;
    }
    ClosestPoints best = between(closestPointOnSegment({a, b}, point), point);
    keepNearer(best, between(closestPointOnSegment({b, c}, point), point));
    keepNearer(best, between(closestPointOnSegment({c, a}, point), point));
    return best.first;
}

/// The unclamped optimum on the first segment gives the best point of the second; clamping that one
/// and going back gives the first's (Ericson 5.1.9).
ClosestPoints closestPoints(const Segment& first, const Segment& second) {
    const vec3 u = first.end - first.start;
    const vec3 v = second.end - second.start;
    const vec3 w = first.start - second.start;
    const float uu = glm::dot(u, u);
    const float uv = glm::dot(u, v);
    const float vv = glm::dot(v, v);
    const float s = clampedRatio(uv * glm::dot(v, w) - vv * glm::dot(u, w), uu * vv - uv * uv);
    const vec3 onSecond = closestPointOnSegment(second, first.start + u * s);
    const vec3 onFirst = closestPointOnSegment(first, onSecond);
    return between(onFirst, onSecond);
}

ClosestPoints closestPoints(const Segment& segment, const vec3& a, const vec3& b, const vec3& c) {
    const vec3 normal = glm::cross(b - a, c - a);
    const float heightStart = glm::dot(segment.start - a, normal);
    const float heightEnd = glm::dot(segment.end - a, normal);
    if (heightStart * heightEnd < 0) {
        const float t = heightStart / (heightStart - heightEnd);
        const vec3 crossing = segment.start + (segment.end - segment.start) * t;
        if (isInside(a, b, c, normal, crossing)) return between(crossing, crossing);
    }
    ClosestPoints best = between(segment.start, closestPointOnTriangle(a, b, c, segment.start));
    keepNearer(best, between(segment.end, closestPointOnTriangle(a, b, c, segment.end)));
    keepNearer(best, closestPoints(segment, {a, b}));
    keepNearer(best, closestPoints(segment, {b, c}));
    keepNearer(best, closestPoints(segment, {c, a}));
    return best;
}

}  // namespace rushlight

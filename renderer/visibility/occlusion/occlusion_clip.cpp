#include "renderer/visibility/occlusion/occlusion_clip.h"

namespace rushlight {
namespace {

/// Always from the inside out, so that it does not matter in which direction an edge is walked.
glm::dvec4 crossing(const glm::dvec4& inside, double distanceInside, const glm::dvec4& outside,
                    double distanceOutside) {
    return inside + (outside - inside) * (distanceInside / (distanceInside - distanceOutside));
}

/// Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974.
ClipPolygon clipAt(const ClipPolygon& in, const glm::dvec4& plane, uint8_t newEdge) {
    ClipPolygon out;
    for (uint32_t i = 0; i < in.count; ++i) {
        const ClipVertex &a = in.vertices[i], &b = in.vertices[(i + 1) % in.count];
        if (out.count + 2 > kMaxClipVertices) return {};
        const double da = glm::dot(plane, a.position), db = glm::dot(plane, b.position);
        if (da >= 0) out.vertices[out.count++] = a;
        if (da >= 0 && db < 0)
            out.vertices[out.count++] = {crossing(a.position, da, b.position, db), 3, newEdge};
        if (da < 0 && db >= 0)
            out.vertices[out.count++] = {crossing(b.position, db, a.position, da), 3, a.edge};
    }
    return out;
}

}  // namespace

ClipPolygon clipTriangle(std::span<const glm::dvec4, 3> corners, double nearFactor,
                         glm::dvec2 guard) {
    ClipPolygon polygon;
    for (uint32_t i = 0; i < 3; ++i) polygon.vertices[i] = {corners[i], i, uint8_t(i)};
    polygon.count = 3;
    const glm::dvec4 planes[] = {{0, 0, -1, nearFactor},
                                 {1, 0, 0, guard.x},
                                 {-1, 0, 0, guard.x},
                                 {0, 1, 0, guard.y},
                                 {0, -1, 0, guard.y}};
    for (uint32_t i = 0; i < 5 && polygon.count > 0; ++i)
        polygon = clipAt(polygon, planes[i], i == 0 ? kEdgeOfNearPlane : kEdgeOfGuardBand);
    return polygon;
}

}  // namespace rushlight

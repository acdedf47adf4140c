#include "tests/support/reference_raster.h"

#include <algorithm>
#include <cmath>

namespace rushlight {

void ReferenceRaster::draw(const ReferenceObject& object, int id) {
    const bool mirrored = glm::determinant(mat3(object.worldFromLocal)) < 0;
    const auto clip = [&](const vec3& p) {
        if (grid_ != VertexGrid::exact)
            return glm::dvec4(clipFromWorld_ * vec4(transformPoint(object.worldFromLocal, p), 1));
        const glm::dmat4x3 m(object.worldFromLocal);
        const glm::dvec3 world = m[0] * double(p.x) + m[1] * double(p.y) + m[2] * double(p.z) +
                                 m[3];
        return glm::dmat4(clipFromWorld_) * glm::dvec4(world, 1);
    };
    for (size_t i = 0; i + 2 < object.indices.size(); i += 3) {
        glm::dvec4 corners[3], kept[4];
        for (size_t k = 0; k < 3; ++k) corners[k] = clip(object.positions[object.indices[i + k]]);
        size_t count = 0;
        for (size_t k = 0; k < 3; ++k) {
            const glm::dvec4 &a = corners[k], &b = corners[(k + 1) % 3];
            const double da = a.w - a.z, db = b.w - b.z;
            if (da >= 0) kept[count++] = a;
            if (da >= 0 && db < 0) kept[count++] = a + (b - a) * (da / (da - db));
            if (da < 0 && db >= 0) kept[count++] = b + (a - b) * (db / (db - da));
        }
        if (count >= 3) drawClipped({kept, count}, mirrored, object.twoSided, id);
    }
}

void ReferenceRaster::drawClipped(std::span<const glm::dvec4> polygon, bool clockwise,
                                  bool twoSided, int id) {
    for (size_t i = 1; i + 1 < polygon.size(); ++i)
        drawTriangle(project(polygon[0]), project(polygon[i]), project(polygon[i + 1]), clockwise,
                     twoSided, id);
}

ReferenceRaster::Corner ReferenceRaster::project(const glm::dvec4& clip) const {
    const auto snap = [&](double v) {
        if (grid_ == VertexGrid::exact) return v;
        return (grid_ == VertexGrid::nearest ? std::round(v * 256) : std::floor(v * 256)) / 256;
    };
    return {snap((clip.x / clip.w * 0.5 + 0.5) * width_),
            snap((clip.y / clip.w * 0.5 + 0.5) * height_), clip.z / clip.w};
}

void ReferenceRaster::drawTriangle(Corner a, Corner b, Corner c, bool clockwise, bool twoSided,
                                   int id) {
    double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (area == 0 || !std::isfinite(area) || (!twoSided && (area < 0) != clockwise)) return;
    if (area < 0) {
        std::swap(b, c);
        area = -area;
    }
    // Positive inside; on the line only one of the two triangles at an edge has the sample.
    const auto weight = [](const Corner& p, const Corner& q, double x, double y) {
        const bool swapped = q.y < p.y || (q.y == p.y && q.x < p.x);
        const Corner &u = swapped ? q : p, &v = swapped ? p : q;
        const double e = (v.x - u.x) * (y - u.y) - (v.y - u.y) * (x - u.x);
        return swapped ? -e : e;
    };
    const auto inside = [](double e, const Corner& p, const Corner& q) {
        return e > 0 || (e == 0 && (q.y < p.y || (q.y == p.y && q.x < p.x)));
    };
    const auto first = [](double low) { return uint32_t(std::max(0.0, std::ceil(low - 0.5))); };
    const auto end = [](double high, uint32_t size) {
        return uint32_t(std::clamp(std::floor(high - 0.5) + 1, 0.0, double(size)));
    };
    const uint32_t endX = end(std::max({a.x, b.x, c.x}), width_),
                   endY = end(std::max({a.y, b.y, c.y}), height_);
    for (uint32_t y = first(std::min({a.y, b.y, c.y})); y < endY; ++y)
        for (uint32_t x = first(std::min({a.x, b.x, c.x})); x < endX; ++x) {
            const double px = x + 0.5, py = y + 0.5;
            const double wa = weight(b, c, px, py), wb = weight(c, a, px, py),
                         wc = weight(a, b, px, py);
            if (!inside(wa, b, c) || !inside(wb, c, a) || !inside(wc, a, b)) continue;
            const double depth = (a.depth * wa + b.depth * wb + c.depth * wc) / area;
            const size_t at = size_t(y) * width_ + x;
            if (depth < 0 || depth <= depths[at]) continue;
            depths[at] = depth;
            ids[at] = id;
        }
}

}  // namespace rushlight

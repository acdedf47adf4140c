#include "renderer/visibility/occlusion/occlusion_setup.h"

#include "renderer/visibility/occlusion/occlusion_clip.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rushlight {
namespace {

constexpr float kLeastGuard = 4096;  // pixels from the middle of the target
// A GPU rounds vertices to a grid, of 1/256 pixel where not finer, and so do we: less than 0.0084
// between the two.
constexpr float kSnapError = 1 / 64.0f;
constexpr uint32_t kClipRoom = 250;  // triangles that clipping may add to an occluder
constexpr float kMaxError = 4;       // pixels; a mesh that is so unsure hides nothing
constexpr float kBeyond = 1e9f;
constexpr uint8_t kLeftOut = 0, kCounterClockwise = 1, kClockwise = 2;

/// Works through one occluder.
///
/// Why a sample that is filled is one that a GPU draws: take the triangles that are kept and face
/// one way as a patch of surface on the screen. Its outline is those of their edges that no other
/// triangle of the patch has the other way round. Around a sample the outline turns as often as
/// triangles cover it. A GPU's vertices are less than `error_` from ours; so is every point of its
/// outline. Unless our outline comes that close to the sample, GPU's turns around it just as often,
/// and some triangle of the patch covers the sample there too, whatever becomes of the edges
/// inside. So triangles are filled with no care for single edges, and samples near the outline are
/// cut out of the whole.
///
/// That triangle may be another than ours, but one that has a vertex in common with it, since all
/// kept triangles are wider than four errors. On the way to it, two errors long, the depth changes
/// by no more than the steepest of the triangles around the vertices allows. That is taken off.
class Setup {
public:
    Setup(const OcclusionView& view, const Occluder& occluder, const SetupMemory& memory)
        : view_(view), occluder_(occluder), mesh_(*occluder.mesh), out_(memory) {}

    FillList run() {
        if (mesh_.triangleCount() == 0 || !prepare()) return {};
        std::fill_n(out_.vertexErrors, mesh_.vertexCount, 0.0f);
        for (uint32_t t = 0; t < mesh_.triangleCount(); ++t) out_.facings[t] = addTriangle(t);
        lowerDepths();
        for (uint32_t t = 0; t < mesh_.triangleCount(); ++t)
            if (out_.facings[t] != kLeftOut) addOutline(t);
        return {{out_.triangles, triangleCount_},
                {out_.triangleRows, triangleCount_},
                {out_.outline, outlineCount_},
                rows_};
    }

private:
    struct Point {
        float x, y, depth;
    };
    struct Polygon {
        Point points[kMaxClipVertices];
        uint8_t edges[kMaxClipVertices];
        uint32_t count;
    };
    struct Plane {
        float x, y;   ///< depth per pixel
        float error;  ///< of the depth anywhere on the triangle and a vertex's error beside it
    };

    bool prepare();
    uint8_t addTriangle(uint32_t triangle);
    uint8_t addPolygon(uint32_t triangle, const Polygon& polygon);
    bool findPlane(const Point& a, const Point& b, const Point& c, Plane& plane) const;
    void fill(uint32_t triangle, Point a, Point b, Point c, const Plane& plane, float leastDepth);
    void lowerDepths();
    void addOutline(uint32_t triangle);
    void addOutline(const Point& a, const Point& b);
    Polygon clip(uint32_t triangle) const;
    Polygon polygonOf(uint32_t triangle) const;
    uint32_t outside(uint32_t triangle) const {
        const uint32_t* v = &mesh_.corners[size_t(triangle) * 3];
        return out_.vertices[v[0]].outside | out_.vertices[v[1]].outside |
               out_.vertices[v[2]].outside;
    }

    const OcclusionView& view_;
    const Occluder& occluder_;
    const OccluderMesh& mesh_;
    const SetupMemory& out_;
    mat4 clipFromLocal_{1};
    float nearFactor_ = 1;
    vec2 half_{1}, guard_{1};
    float greatestPixel_ = 0;
    float error_ = 0;  ///< pixels between where a GPU has a point of the surface and where we have
                       ///< it
    float relativeDepth_ = 0;  ///< error of depth, relative
    float absoluteDepth_ = 0;
    bool mirrored_ = false;
    uint32_t triangleCount_ = 0, outlineCount_ = 0;
    RowRange rows_{0xffff, 0};
};

/// Projects the vertices and works out the errors. False when they are too great for anything to be
/// sure.
bool Setup::prepare() {
    const mat4& clip = view_.clipFromWorld;
    clipFromLocal_ = clip * toMat4(occluder_.worldFromLocal);
    mirrored_ = glm::determinant(mat3(occluder_.worldFromLocal)) < 0;
    vec3 reach = glm::abs(occluder_.worldFromLocal[3]);
    for (int i = 0; i < 3; ++i) reach += glm::abs(occluder_.worldFromLocal[i]) * mesh_.reach[i];
    vec4 magnitude = glm::abs(clip[3]);
    for (int i = 0; i < 3; ++i) magnitude += glm::abs(clip[i]) * reach[i];
    const vec4 wrong = magnitude * kTransformError;
    if (!std::isfinite(wrong.x + wrong.y + wrong.z + wrong.w)) return false;

    half_ = 0.5f * vec2(float(view_.width), float(view_.height));
    // Beyond twice the target nothing is to be seen; short coordinates are exact ones.
    const float guard = std::max({kLeastGuard, 2 * half_.x, 2 * half_.y});
    guard_ = guard / half_;
    // A little behind the near plane, so that what a GPU clips there is surely clipped here.
    const float margin = view_.nearW > 0
                             ? std::max(1 / 256.0f, 4 * (wrong.w + wrong.z) / view_.nearW)
                             : 1 / 256.0f;
    nearFactor_ = 1 - std::min(margin, 0.5f);
    const ProjectedBounds bounds = projectVertices(
        mesh_, {clipFromLocal_, half_.x, half_.y, nearFactor_, guard_.x, guard_.y}, out_.vertices);
    float leastW = bounds.leastW;
    greatestPixel_ = std::max({bounds.greatestPixel, float(view_.width), float(view_.height)});
    if (bounds.outsideAny)
        greatestPixel_ = std::max(greatestPixel_, guard + std::max(half_.x, half_.y));
    if (bounds.outsideAny && view_.nearW > 0) leastW = std::min(leastW, view_.nearW);

    const float pixels = std::max(wrong.x * half_.x, wrong.y * half_.y) +
                         wrong.w * std::max(half_.x, half_.y);
    error_ = kSnapError + kPixelError * greatestPixel_ + 1.5f * pixels / leastW;
    relativeDepth_ = wrong.w / leastW;
    absoluteDepth_ = wrong.z / leastW;
    return error_ < kMaxError && relativeDepth_ < 0.25f && margin <= 0.5f;
}

uint8_t Setup::addTriangle(uint32_t triangle) {
    const uint32_t* v = &mesh_.corners[size_t(triangle) * 3];
    const ScreenVertex &a = out_.vertices[v[0]], &b = out_.vertices[v[1]], &c = out_.vertices[v[2]];
    if (a.outside & b.outside & c.outside) return kLeftOut;
    if (a.outside | b.outside | c.outside) {
        const Polygon polygon = clip(triangle);
        return polygon.count < 3 ? kLeftOut : addPolygon(triangle, polygon);
    }
    const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    const uint8_t facing = area > 0 ? kCounterClockwise : kClockwise;
    if (!occluder_.twoSided && (facing == kClockwise) != mirrored_) return kLeftOut;
    return addPolygon(triangle, polygonOf(triangle));
}

/// Cuts a convex polygon into triangles, all on the plane of the largest.
uint8_t Setup::addPolygon(uint32_t triangle, const Polygon& polygon) {
    const Point* p = polygon.points;
    float largest = 0, lowX = p[0].x, highX = lowX, lowY = p[0].y, highY = lowY;
    float leastDepth = p[0].depth, greatestDepth = p[0].depth;
    uint32_t best = 1;
    for (uint32_t i = 1; i < polygon.count; ++i) {
        lowX = std::min(lowX, p[i].x);
        highX = std::max(highX, p[i].x);
        lowY = std::min(lowY, p[i].y);
        highY = std::max(highY, p[i].y);
        leastDepth = std::min(leastDepth, p[i].depth);
        greatestDepth = std::max(greatestDepth, p[i].depth);
        if (i + 1 == polygon.count) break;
        const float area = (p[i].x - p[0].x) * (p[i + 1].y - p[0].y) -
                           (p[i + 1].x - p[0].x) * (p[i].y - p[0].y);
        if (std::abs(area) > std::abs(largest)) {
            largest = area;
            best = i;
        }
    }
    // Farther off the target than any error reaches: nobody misses it.
    if (highX < -kMaxError || highY < -kMaxError || lowX > 2 * half_.x + kMaxError ||
        lowY > 2 * half_.y + kMaxError)
        return kLeftOut;
    const uint8_t facing = largest > 0 ? kCounterClockwise : kClockwise;
    if (!occluder_.twoSided && (facing == kClockwise) != mirrored_) return kLeftOut;
    const uint32_t room = uint32_t(occluderRoom(mesh_).triangles) -
                          (mesh_.triangleCount() - triangle);
    if (triangleCount_ + polygon.count - 3 > room) return kLeftOut;
    Plane plane;
    if (!findPlane(p[0], p[best], p[best + 1], plane)) return kLeftOut;
    plane.error += greatestDepth * kPixelError + absoluteDepth_;
    if (!(plane.error <= greatestDepth / 32)) return kLeftOut;

    for (uint32_t i = 1; i + 1 < polygon.count; ++i)
        fill(triangle, p[0], p[i], p[i + 1], plane, leastDepth);
    for (uint32_t k = 0; k < 3; ++k) {
        float& worst = out_.vertexErrors[mesh_.corners[size_t(triangle) * 3 + k]];
        worst = std::max(worst, plane.error);
    }
    return facing;
}

/// False for a triangle that is too thin. A GPU works out planes in float: the error is greater for
/// a badly shaped one.
bool Setup::findPlane(const Point& a, const Point& b, const Point& c, Plane& plane) const {
    const double bx = double(b.x) - a.x, by = double(b.y) - a.y, cx = double(c.x) - a.x,
                 cy = double(c.y) - a.y;
    const double area = bx * cy - by * cx;
    const double longest = std::sqrt(std::max(
        {bx * bx + by * by, cx * cx + cy * cy, (cx - bx) * (cx - bx) + (cy - by) * (cy - by)}));
    if (!(std::abs(area) > 4 * double(error_) * longest)) return false;
    const double bz = double(b.depth) - a.depth, cz = double(c.depth) - a.depth;
    plane.x = float((bz * cy - cz * by) / area);
    plane.y = float((bx * cz - cx * bz) / area);
    const float condition = float(longest * longest / std::abs(area));
    const float pixels = 2 * error_ + (kPixelError + kPlaneError * condition) * greatestPixel_;
    plane.error = (std::abs(plane.x) + std::abs(plane.y)) * pixels;
    return true;
}

void Setup::fill(uint32_t triangle, Point a, Point b, Point c, const Plane& plane,
                 float leastDepth) {
    if (b.y < a.y) std::swap(a, b);
    if (c.y < a.y) std::swap(a, c);
    if (c.y < b.y) std::swap(b, c);
    const float firstRow = std::max(std::ceil(a.y - 0.5f), 0.0f);
    const float lastRow = std::min(std::floor(c.y - 0.5f), 2 * half_.y - 1);
    if (!(firstRow <= lastRow) || std::max({a.x, b.x, c.x}) < 0 ||
        std::min({a.x, b.x, c.x}) > 2 * half_.x)
        return;

    // An edge's line is worked out from its lower to its upper end: both triangles at it get the
    // same bits.
    const auto slope = [](const Point& low, const Point& high) {
        return high.y > low.y ? (high.x - low.x) / (high.y - low.y) : 0.0f;
    };
    FillTriangle out;
    out.lowX = a.x;
    out.lowY = a.y;
    out.midX = b.x;
    out.midY = b.y;
    out.longSlope = slope(a, c);
    out.lowSlope = slope(a, b);
    out.highSlope = slope(b, c);
    out.longIsLeft = (c.x - a.x) * (b.y - a.y) < (b.x - a.x) * (c.y - a.y);
    const float beyond = out.longIsLeft ? kBeyond : -kBeyond;
    out.lowEdgeX = b.y > a.y ? a.x : beyond;
    out.highX = c.y > b.y ? b.x : beyond;
    const float safe = 1 - relativeDepth_;
    out.depth = a.depth * safe;
    out.depthX = plane.x * safe;
    out.depthY = plane.y * safe;
    out.leastDepth = leastDepth * safe;

    const RowRange rows{uint16_t(firstRow), uint16_t(lastRow)};
    rows_ = {std::min(rows_.first, rows.first), std::max(rows_.last, rows.last)};
    out_.triangles[triangleCount_] = out;
    out_.triangleRows[triangleCount_] = rows;
    out_.sources[triangleCount_++] = triangle;
}

/// Takes off what the triangles around a triangle's vertices may be farther.
void Setup::lowerDepths() {
    for (uint32_t i = 0; i < triangleCount_; ++i) {
        const uint32_t* v = &mesh_.corners[size_t(out_.sources[i]) * 3];
        const float error = std::max(
            {out_.vertexErrors[v[0]], out_.vertexErrors[v[1]], out_.vertexErrors[v[2]]});
        out_.triangles[i].depth -= error;
        out_.triangles[i].leastDepth -= error;
    }
}

void Setup::addOutline(uint32_t triangle) {
    bool inner[5] = {false, false, false, false, true};
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t other = mesh_.neighbours[size_t(triangle) * 3 + k];
        inner[k] = other != OccluderMesh::kNone && out_.facings[other] == out_.facings[triangle];
    }
    if (inner[0] && inner[1] && inner[2] && !outside(triangle)) return;
    const Polygon polygon = outside(triangle) ? clip(triangle) : polygonOf(triangle);
    for (uint32_t i = 0; i < polygon.count; ++i)
        if (!inner[polygon.edges[i]])
            addOutline(polygon.points[i], polygon.points[(i + 1) % polygon.count]);
}

void Setup::addOutline(const Point& a, const Point& b) {
    const Point &low = a.y <= b.y ? a : b, &high = a.y <= b.y ? b : a;
    OutlineEdge edge;
    edge.left = std::min(a.x, b.x) - error_;
    edge.right = std::max(a.x, b.x) + error_;
    const float firstRow = std::max(std::ceil(low.y - error_ - 0.5f), 0.0f);
    const float lastRow = std::min(std::floor(high.y + error_ - 0.5f), 2 * half_.y - 1);
    if (!(firstRow <= lastRow) || edge.right < 0 || edge.left > 2 * half_.x) return;
    const bool flat = high.y == low.y;
    edge.x = low.x;
    edge.y = low.y;
    edge.slope = flat ? 0 : (high.x - low.x) / (high.y - low.y);
    edge.reach = flat ? kBeyond : error_ * (1 + std::abs(edge.slope));
    edge.firstRow = uint16_t(firstRow);
    edge.lastRow = uint16_t(lastRow);
    out_.outline[outlineCount_++] = edge;
}

Setup::Polygon Setup::polygonOf(uint32_t triangle) const {
    Polygon polygon{{}, {0, 1, 2}, 3};
    for (uint32_t k = 0; k < 3; ++k) {
        const ScreenVertex& v = out_.vertices[mesh_.corners[size_t(triangle) * 3 + k]];
        polygon.points[k] = {v.x, v.y, v.depth};
    }
    return polygon;
}

Setup::Polygon Setup::clip(uint32_t triangle) const {
    Polygon polygon{};
    const uint32_t* v = &mesh_.corners[size_t(triangle) * 3];
    glm::dvec4 corners[3];
    if (!(view_.nearW > 0)) return polygon;
    for (uint32_t k = 0; k < 3; ++k)
        corners[k] = glm::dvec4(clipFromLocal_ *
                                vec4(mesh_.x[v[k]], mesh_.y[v[k]], mesh_.z[v[k]], 1));
    const ClipPolygon clipped = clipTriangle(corners, double(nearFactor_), glm::dvec2(guard_));
    for (uint32_t i = 0; i < clipped.count; ++i) {
        const ClipVertex& c = clipped.vertices[i];
        Point& point = polygon.points[i];
        polygon.edges[i] = c.edge;
        if (c.corner < 3 && !out_.vertices[v[c.corner]].outside) {
            const ScreenVertex& known = out_.vertices[v[c.corner]];
            point = {known.x, known.y, known.depth};
            continue;
        }
        if (!(c.position.w > 0.5 * double(view_.nearW))) return {};
        const glm::dvec2 pixel = (glm::dvec2(c.position) / c.position.w + 1.0) * glm::dvec2(half_);
        point.x = float(std::round(pixel.x * 256) / 256);
        point.y = float(std::round(pixel.y * 256) / 256);
        point.depth = float(c.position.z / c.position.w);
    }
    polygon.count = clipped.count;
    return polygon;
}

}  // namespace

OcclusionView OcclusionView::make(const mat4& clipFromWorld, uint32_t width, uint32_t height) {
    OcclusionView view{clipFromWorld, width, height, 0};
    const mat4 rows = glm::transpose(clipFromWorld);
    const vec3 z(rows[2]), w(rows[3]);
    const float square = glm::dot(w, w);
    if (square == 0) {
        view.nearW = rows[3].w;
        return view;
    }
    // z = a * w + b everywhere when both grow in one direction; then z = w at w = b / (1 - a).
    const float a = glm::dot(z, w) / square;
    if (glm::length(z - a * w) <= 1e-5f * glm::length(w)) {
        const float nearW = (rows[2].w - a * rows[3].w) / (1 - a);
        if (std::isfinite(nearW)) view.nearW = std::max(nearW, 0.0f);
    }
    return view;
}

OccluderRoom occluderRoom(const OccluderMesh& mesh) {
    const size_t triangles = mesh.triangleCount();
    return {paddedToLanes(mesh.vertexCount), triangles,
            triangles + std::min<size_t>(5 * triangles, kClipRoom), 4 * triangles + kMaxLanes};
}

FillList setUpOccluder(const OcclusionView& view, const Occluder& occluder,
                       const SetupMemory& memory) {
    return Setup(view, occluder, memory).run();
}

}  // namespace rushlight

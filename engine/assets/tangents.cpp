#include "engine/assets/tangents.h"

#include "engine/assets/geometry_tools.h"
#include "engine/core/hash.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <unordered_map>

namespace rushlight::assets {
namespace {

/// What decides that two corners meet in one vertex: everything the tangent depends on, bit by bit.
struct CornerKey {
    float values[8];

    bool operator==(const CornerKey& other) const {
        return std::memcmp(values, other.values, sizeof values) == 0;
    }
};

struct CornerKeyHash {
    size_t operator()(const CornerKey& key) const {
        return hashBytes(key.values, sizeof key.values);
    }
};

struct Face {
    vec3 tangent{0};  ///< direction of increasing u
    bool mirrored = false;
    bool degenerate = true;  ///< no area in space or in uv: has no tangent of its own
};

vec3 unitOrZero(const vec3& v) {
    const float length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : vec3(0);
}

vec3 projected(const vec3& v, const vec3& normal) {
    return unitOrZero(v - normal * glm::dot(normal, v));
}

/// Any direction in the plane of the normal, for corners without a usable uv.
vec3 anyTangent(const vec3& normal) {
    return projected(std::abs(normal.x) < 0.9f ? vec3(1, 0, 0) : vec3(0, 1, 0), normal);
}

class TangentMaker {
public:
    TangentMaker(Geometry& geometry, const std::vector<vec2>& uv) : geometry_(geometry), uv_(uv) {}

    void run() {
        weld();
        makeFaces();
        cornerTangent_.assign(geometry_.indices.size(), vec4(0));
        for (size_t v = 0; v + 1 < firstCorner_.size(); ++v)
            makeVertex({&cornersOfVertex_[firstCorner_[v]], firstCorner_[v + 1] - firstCorner_[v]});
        split();
    }

private:
    struct Corners {
        const uint32_t* data;
        size_t count;
    };

    static uint32_t next(uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
    static uint32_t previous(uint32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

    CornerKey keyOf(uint32_t vertex) const {
        const vec3& p = geometry_.positions[vertex];
        const vec3& n = geometry_.normals[vertex];
        const vec2& t = uv_[vertex];
        // + 0.0f: minus zero and zero are the same place
        return {{p.x + 0.0f, p.y + 0.0f, p.z + 0.0f, n.x + 0.0f, n.y + 0.0f, n.z + 0.0f, t.x + 0.0f,
                 t.y + 0.0f}};
    }

    /// Numbers the distinct vertices and lists the corners at each.
    void weld() {
        const size_t vertexCount = geometry_.positions.size();
        std::unordered_map<CornerKey, uint32_t, CornerKeyHash> seen;
        seen.reserve(vertexCount);
        std::vector<uint32_t> weldOf(vertexCount);
        for (uint32_t v = 0; v < vertexCount; ++v)
            weldOf[v] = seen.try_emplace(keyOf(v), uint32_t(seen.size())).first->second;
        welded_.resize(geometry_.indices.size());
        firstCorner_.assign(seen.size() + 1, 0);
        for (size_t c = 0; c < welded_.size(); ++c) {
            welded_[c] = weldOf[geometry_.indices[c]];
            ++firstCorner_[welded_[c] + 1];
        }
        std::partial_sum(firstCorner_.begin(), firstCorner_.end(), firstCorner_.begin());
        cornersOfVertex_.resize(welded_.size());
        std::vector<uint32_t> at(firstCorner_.begin(), firstCorner_.end() - 1);
        for (uint32_t c = 0; c < welded_.size(); ++c) cornersOfVertex_[at[welded_[c]]++] = c;
    }

    void makeFaces() {
        faces_.resize(geometry_.indices.size() / 3);
        for (size_t f = 0; f < faces_.size(); ++f) {
            const uint32_t* i = &geometry_.indices[f * 3];
            const vec3 e1 = geometry_.positions[i[1]] - geometry_.positions[i[0]];
            const vec3 e2 = geometry_.positions[i[2]] - geometry_.positions[i[0]];
            const vec2 t1 = uv_[i[1]] - uv_[i[0]], t2 = uv_[i[2]] - uv_[i[0]];
            const float area = t1.x * t2.y - t1.y * t2.x;
            Face& face = faces_[f];
            face.mirrored = !(area > 0);
            const vec3 direction = unitOrZero(t2.y * e1 - t1.y * e2);
            face.tangent = face.mirrored ? -direction : direction;
            face.degenerate = area == 0 || direction == vec3(0) || glm::cross(e1, e2) == vec3(0);
        }
    }

    /// Corners a and b share the edge from their vertex to a's next one, run through in opposite
    /// directions.
    bool adjacent(uint32_t a, uint32_t b) const {
        return welded_[next(a)] == welded_[previous(b)] &&
               faces_[a / 3].mirrored == faces_[b / 3].mirrored;
    }

    void makeVertex(Corners corners) {
        group_.assign(corners.count, kNone);
        vec4 fallback(0);
        for (size_t seed = 0; seed < corners.count; ++seed) {
            if (group_[seed] != kNone || faces_[corners.data[seed] / 3].degenerate) continue;
            const vec4 tangent = growGroup(corners, seed);
            if (fallback == vec4(0)) fallback = tangent;
        }
        for (size_t i = 0; i < corners.count; ++i) {
            if (group_[i] != kNone) continue;
            const vec3& normal = geometry_.normals[geometry_.indices[corners.data[i]]];
            cornerTangent_[corners.data[i]] = fallback == vec4(0) ? vec4(anyTangent(normal), 1)
                                                                  : fallback;
        }
    }

    /// Flood fill over the edges at this vertex; the sum is taken in the order of the corners.
    vec4 growGroup(Corners corners, size_t seed) {
        stack_.assign(1, seed);
        group_[seed] = seed;
        while (!stack_.empty()) {
            const uint32_t corner = corners.data[stack_.back()];
            stack_.pop_back();
            for (size_t i = 0; i < corners.count; ++i) {
                const uint32_t other = corners.data[i];
                if (group_[i] != kNone || faces_[other / 3].degenerate) continue;
                if (!adjacent(corner, other) && !adjacent(other, corner)) continue;
                group_[i] = seed;
                stack_.push_back(i);
            }
        }
        vec3 sum(0);
        for (size_t i = 0; i < corners.count; ++i)
            if (group_[i] == seed) sum += weighted(corners.data[i]);
        const uint32_t first = corners.data[seed];
        const vec3& normal = geometry_.normals[geometry_.indices[first]];
        const vec3 unit = unitOrZero(sum);
        const vec4 tangent(unit == vec3(0) ? anyTangent(normal) : unit,
                           faces_[first / 3].mirrored ? 1.0f : -1.0f);
        for (size_t i = 0; i < corners.count; ++i)
            if (group_[i] == seed) cornerTangent_[corners.data[i]] = tangent;
        return tangent;
    }

    vec3 weighted(uint32_t corner) const {
        const vec3& normal = geometry_.normals[geometry_.indices[corner]];
        const vec3& here = geometry_.positions[geometry_.indices[corner]];
        const vec3 a = projected(geometry_.positions[geometry_.indices[next(corner)]] - here,
                                 normal);
        const vec3 b = projected(geometry_.positions[geometry_.indices[previous(corner)]] - here,
                                 normal);
        const float angle = std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f));
        return angle * projected(faces_[corner / 3].tangent, normal);
    }

    /// A vertex keeps its number for the first tangent and gets a copy for each other one.
    void split() {
        constexpr uint32_t kUnset = ~0u;
        const size_t vertexCount = geometry_.positions.size();
        std::vector<uint32_t> source(vertexCount), copyOf(vertexCount, kUnset);
        std::iota(source.begin(), source.end(), 0u);
        std::vector<vec4> tangents(vertexCount, vec4(0));
        for (size_t c = 0; c < geometry_.indices.size(); ++c) {
            uint32_t vertex = geometry_.indices[c];
            while (tangents[vertex] != vec4(0) && tangents[vertex] != cornerTangent_[c]) {
                if (copyOf[vertex] == kUnset) {
                    copyOf[vertex] = uint32_t(source.size());
                    source.push_back(source[vertex]);
                    copyOf.push_back(kUnset);
                    tangents.push_back(vec4(0));
                }
                vertex = copyOf[vertex];
            }
            tangents[vertex] = cornerTangent_[c];
            geometry_.indices[c] = vertex;
        }
        if (source.size() > vertexCount) gatherVertices(geometry_, source);
        for (size_t v = 0; v < tangents.size(); ++v)
            if (tangents[v] == vec4(0)) tangents[v] = vec4(anyTangent(geometry_.normals[v]), 1);
        geometry_.tangents = std::move(tangents);
    }

    static constexpr size_t kNone = ~size_t(0);

    Geometry& geometry_;
    const std::vector<vec2>& uv_;
    std::vector<uint32_t> welded_;       ///< of each corner: its distinct vertex
    std::vector<uint32_t> firstCorner_;  ///< of each distinct vertex, into cornersOfVertex_
    std::vector<uint32_t> cornersOfVertex_;
    std::vector<Face> faces_;
    std::vector<vec4> cornerTangent_;
    std::vector<size_t> group_, stack_;  ///< of the vertex at hand
};

}  // namespace

void makeTangents(Geometry& geometry, int uvSet) {
    const std::vector<vec2>& uv = uvSet == 1 ? geometry.uv1 : geometry.uv0;
    geometry.tangents.clear();
    TangentMaker(geometry, uv).run();
}

}  // namespace rushlight::assets

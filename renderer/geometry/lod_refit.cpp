#include "renderer/geometry/lod_refit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rushlight {
namespace {

constexpr int kIterations = 10;
// What it costs to move as a share of what it costs to leave the surface: decides along the
// surface, where nothing else does.
constexpr float kStay = 0.02f;
constexpr float kAlike = 0.02f;  // of the farthest distance: what is nearer needs no closer look

// A square's mean over a triangle, exact up to cubic polynomials, is that of its corners, the
// middles of its sides and its centre with these weights (Zienkiewicz, The Finite Element Method,
// table of numerical integration).
constexpr float kCornerWeight = 1.0f / 20, kMiddleWeight = 2.0f / 15, kCentreWeight = 9.0f / 20;

// A point of the level: `distance` above the tangent plane of the original, and the more when its
// places move.
struct Sample {
    vec3 normal;  // times the root of the weight, as is `distance`
    float distance;
    std::array<uint32_t, 3> places;
    vec3 shares;
};

class Fit {
public:
    Fit(const LevelSurface& level, const SurfaceGrid& original, float farthest)
        : level_(level), original_(original), farthest_(farthest) {
        const auto& indices = level.indices;
        fixed_.assign(level.placeCount, false);
        areas_.resize(indices.size() / 3);
        for (size_t t = 0; t < areas_.size(); ++t) {
            const vec3& a = level.positions[indices[t * 3]];
            areas_[t] = glm::length(glm::cross(level.positions[indices[t * 3 + 1]] - a,
                                               level.positions[indices[t * 3 + 2]] - a));
        }
        findEdges();
        samples_.reserve(edges_.size() + areas_.size() * 4);
        for (size_t t = 0; t < areas_.size(); ++t) sampleTriangle(t);
        sampleEdges();
    }

    /// By conjugate gradients on the normal equations (Hestenes and Stiefel, 1952), scaled by their
    /// diagonal.
    std::vector<vec3> offsets() const {
        const size_t count = level_.placeCount;
        std::vector<float> scale(count, 0);  // of the diagonal blocks, their mean
        for (const Sample& s : samples_)
            for (int k = 0; k < 3; ++k)
                scale[s.places[size_t(k)]] += s.shares[k] * s.shares[k] *
                                              glm::dot(s.normal, s.normal);
        std::vector<vec3> moved(count, vec3(0)), rest = slope(moved, true, scale), step(count),
                                                 image;
        double before = 0;
        for (int i = 0; i < kIterations; ++i) {
            double now = 0;
            for (size_t p = 0; p < count; ++p)
                if (scale[p] > 0) now += double(glm::dot(rest[p], rest[p]) / scale[p]);
            if (!(now > 0)) break;
            for (size_t p = 0; p < count; ++p)
                if (scale[p] > 0)
                    step[p] = rest[p] / scale[p] + (i > 0 ? float(now / before) : 0.0f) * step[p];
            before = now;
            image = slope(step, false, scale);
            double along = 0;
            for (size_t p = 0; p < count; ++p) along += double(glm::dot(step[p], image[p]));
            if (!(along < 0)) break;
            const float length = float(-now / along);
            for (size_t p = 0; p < count; ++p) {
                moved[p] += length * step[p];
                rest[p] += length * image[p];
            }
        }
        for (vec3& offset : moved) {
            const float length = glm::length(offset);
            if (!std::isfinite(length)) return std::vector<vec3>(count, vec3(0));
            if (length > farthest_) offset *= farthest_ / length;
        }
        return moved;
    }

private:
    struct Edge {
        uint64_t key;     // the places, the lower one first
        uint32_t corner;  // of the indices: the edge goes from it to the triangle's next
        bool forward;
    };

    static size_t next(size_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
    uint32_t placeAt(size_t corner) const { return level_.places[level_.indices[corner]]; }

    // Sorted, and the places of open borders fixed.
    void findEdges() {
        for (uint32_t c = 0; c < level_.indices.size(); ++c) {
            const uint64_t a = placeAt(c), b = placeAt(next(c));
            if (a != b) edges_.push_back({std::min(a, b) << 32 | std::max(a, b), c, a < b});
        }
        std::sort(edges_.begin(), edges_.end(), [](const Edge& x, const Edge& y) {
            return x.key != y.key ? x.key < y.key : x.corner < y.corner;
        });
        forRuns([&](size_t first, size_t last) {
            int balance = 0;
            for (size_t e = first; e < last; ++e) balance += edges_[e].forward ? 1 : -1;
            if (balance == 0) return;
            fixed_[edges_[first].key >> 32] = true;
            fixed_[edges_[first].key & 0xffffffff] = true;
        });
    }

    template <class F>
    void forRuns(F&& f) const {
        for (size_t first = 0, last; first < edges_.size(); first = last) {
            for (last = first; last < edges_.size() && edges_[last].key == edges_[first].key;)
                ++last;
            f(first, last);
        }
    }

    void sampleTriangle(size_t t) {
        const uint32_t* v = &level_.indices[t * 3];
        const std::array<uint32_t, 3> places = {level_.places[v[0]], level_.places[v[1]],
                                                level_.places[v[2]]};
        if (fixed_[places[0]] && fixed_[places[1]] && fixed_[places[2]]) return;
        const auto &p = level_.positions, &n = level_.normals;
        for (int k = 0; k < 3; ++k) {  // the corners are on the original
            vec3 share(0);
            share[k] = 1;
            samples_.push_back({n[v[k]] * std::sqrt(kCornerWeight * areas_[t]), 0, places, share});
        }
        sample((p[v[0]] + p[v[1]] + p[v[2]]) / 3.0f, n[v[0]] + n[v[1]] + n[v[2]],
               kCentreWeight * areas_[t], places, vec3(1.0f / 3));
    }

    void sampleEdges() {
        forRuns([&](size_t first, size_t last) {
            const uint32_t low = uint32_t(edges_[first].key >> 32),
                           high = uint32_t(edges_[first].key & 0xffffffff);
            if (fixed_[low] && fixed_[high]) return;
            for (size_t e = first; e < last; ++e) {
                const uint32_t a = level_.indices[edges_[e].corner],
                               b = level_.indices[next(edges_[e].corner)];
                float area = areas_[edges_[e].corner / 3];
                if (last == first + 2) {  // a soft edge is one sample
                    const uint32_t other = edges_[first + last - 1 - e].corner;
                    if (level_.indices[other] == b && level_.indices[next(other)] == a) {
                        if (e > first) return;
                        area += areas_[other / 3];
                    }
                }
                sample((level_.positions[a] + level_.positions[b]) / 2.0f,
                       level_.normals[a] + level_.normals[b], kMiddleWeight * area,
                       {level_.places[a], level_.places[b], level_.places[b]}, vec3(0.5f, 0.5f, 0));
            }
        });
    }

    void sample(const vec3& point, const vec3& normal, float weight,
                const std::array<uint32_t, 3>& places, const vec3& shares) {
        const auto plane = original_.nearestPlane(point, normal, kAlike * farthest_, farthest_);
        if (!plane) return;
        const float root = std::sqrt(weight);
        samples_.push_back({plane->normal * root, plane->distance * root, places, shares});
    }

    // Downhill of half the squares' sum; with `absolute` at `moved`, else how that changes with
    // `moved`.
    std::vector<vec3> slope(const std::vector<vec3>& moved, bool absolute,
                            const std::vector<float>& scale) const {
        std::vector<vec3> down(moved.size());
        for (size_t p = 0; p < down.size(); ++p) down[p] = -kStay * scale[p] * moved[p];
        for (const Sample& s : samples_) {
            const vec3 at = s.shares[0] * moved[s.places[0]] + s.shares[1] * moved[s.places[1]] +
                            s.shares[2] * moved[s.places[2]];
            const vec3 pull = s.normal * -((absolute ? s.distance : 0.0f) + glm::dot(s.normal, at));
            for (int k = 0; k < 3; ++k) down[s.places[size_t(k)]] += s.shares[k] * pull;
        }
        for (size_t p = 0; p < down.size(); ++p)
            if (fixed_[p]) down[p] = vec3(0);
        return down;
    }

    const LevelSurface& level_;
    const SurfaceGrid& original_;
    const float farthest_;
    std::vector<bool> fixed_;   // by place
    std::vector<float> areas_;  // of triangles, doubled
    std::vector<Edge> edges_;
    std::vector<Sample> samples_;
};

}  // namespace

std::vector<vec3> refit(const LevelSurface& level, const SurfaceGrid& original, float farthest) {
    return Fit(level, original, farthest).offsets();
}

}  // namespace rushlight

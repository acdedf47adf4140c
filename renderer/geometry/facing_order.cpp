// How triangles are grouped: by k-means of their normals on the sphere.
#include "renderer/geometry/facing_groups.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <meshoptimizer.h>

namespace rushlight {
namespace {

constexpr uint32_t kTrianglesPerGroup = 12;  // at least, about: a draw costs as much as some
                                             // triangles
constexpr size_t kSamples = 512;             // normals that decide where the groups are
constexpr int kRounds = 5;

// Radians around a cone: a rasteriser snaps corners to a part of a pixel, which turns what it sees
// edge-on.
constexpr float kConeMargin = 0.01f;
constexpr float kPlaneMargin = 1e-5f;  // of the mesh's extent

struct Normals {
    std::vector<vec3> of;  // by triangle; zero of those that have none worth the name
    Normals(std::span<const vec3> positions, std::span<const uint32_t> indices)
        : of(indices.size() / 3) {
        for (size_t t = 0; t < of.size(); ++t) {
            const vec3& a = positions[indices[t * 3]];
            const vec3 ab = positions[indices[t * 3 + 1]] - a,
                       ac = positions[indices[t * 3 + 2]] - a;
            const vec3 normal = glm::cross(ab, ac);
            const float area = glm::length(normal);
            const float side = std::max(glm::dot(ab, ab), glm::dot(ac, ac));
            constexpr float kThin = 1e-4f;
            of[t] = area > kThin * side ? normal / area : vec3(0);
        }
    }
};

uint32_t nearest(const std::vector<vec3>& axes, const vec3& normal) {
    uint32_t best = 0;
    for (uint32_t k = 1; k < axes.size(); ++k)
        if (glm::dot(axes[k], normal) > glm::dot(axes[best], normal)) best = k;
    return best;
}

// Of normals that are spread over all, the one farthest from those picked is picked next (Gonzalez,
// 1985).
std::vector<vec3> firstAxes(const std::vector<vec3>& samples, uint32_t count) {
    constexpr float kSame = 0.9999f;
    std::vector<vec3> axes;
    std::vector<float> closeness(samples.size(), -2);
    size_t next = 0;
    while (axes.size() < count) {
        axes.push_back(samples[next]);
        for (size_t i = 0; i < samples.size(); ++i)
            closeness[i] = std::max(closeness[i], glm::dot(samples[i], axes.back()));
        next = size_t(std::ranges::min_element(closeness) - closeness.begin());
        if (closeness[next] > kSame) break;
    }
    return axes;
}

// Lloyd's iteration, but towards the axis of the least cone: the middle between the mean and the
// outermost.
void settle(std::vector<vec3>& axes, const std::vector<vec3>& samples) {
    std::vector<uint32_t> groupOf(samples.size());
    for (int round = 0; round < kRounds; ++round) {
        std::vector<vec3> sums(axes.size(), vec3(0)), outermost(axes.size(), vec3(0));
        for (size_t i = 0; i < samples.size(); ++i) {
            groupOf[i] = nearest(axes, samples[i]);
            sums[groupOf[i]] += samples[i];
        }
        for (size_t k = 0; k < axes.size(); ++k)
            if (glm::length(sums[k]) > 1e-3f) axes[k] = glm::normalize(sums[k]);
        constexpr int kPulls = 4;
        for (int pull = 1; pull <= kPulls; ++pull) {
            std::vector<float> least(axes.size(), 2);
            for (size_t i = 0; i < samples.size(); ++i) {
                const float along = glm::dot(axes[groupOf[i]], samples[i]);
                if (along < least[groupOf[i]]) {
                    least[groupOf[i]] = along;
                    outermost[groupOf[i]] = samples[i];
                }
            }
            for (size_t k = 0; k < axes.size(); ++k)
                if (least[k] < 1)
                    axes[k] = glm::normalize(axes[k] +
                                             (outermost[k] - axes[k] * least[k]) / float(pull + 2));
        }
    }
}

// Neighbours beside each other, so that what is seen is in few runs: from one to the nearest that
// is left, then stretches turned round as long as that shortens the way (Croes, 1958).
void order(std::vector<vec3>& axes) {
    const auto apart = [&](size_t a, size_t b) { return glm::distance(axes[a], axes[b]); };
    for (size_t i = 1; i < axes.size(); ++i)
        for (size_t j = i + 1; j < axes.size(); ++j)
            if (glm::dot(axes[i - 1], axes[j]) > glm::dot(axes[i - 1], axes[i]))
                std::swap(axes[i], axes[j]);
    constexpr int kMostTurns = 8;
    bool turned = true;
    for (int turn = 0; turn < kMostTurns && turned; ++turn) {
        turned = false;
        for (size_t i = 0; i + 1 < axes.size(); ++i)
            for (size_t j = i + 1; j < axes.size(); ++j) {
                const bool before = i > 0, after = j + 1 < axes.size();
                const float now = (before ? apart(i - 1, i) : 0) + (after ? apart(j, j + 1) : 0);
                const float then = (before ? apart(i - 1, j) : 0) + (after ? apart(i, j + 1) : 0);
                if (then > now - 1e-4f) continue;
                std::reverse(axes.begin() + std::ptrdiff_t(i),
                             axes.begin() + std::ptrdiff_t(j) + 1);
                turned = true;
            }
    }
}

// As meshoptimizer's, over the vertices of the group alone.
class CacheOrder {
public:
    explicit CacheOrder(size_t vertices) : localOf_(vertices, kNone) {}

    void apply(std::span<uint32_t> indices) {
        names_.clear();
        local_.resize(indices.size());
        for (size_t i = 0; i < indices.size(); ++i) {
            uint32_t& local = localOf_[indices[i]];
            if (local == kNone) {
                local = uint32_t(names_.size());
                names_.push_back(indices[i]);
            }
            local_[i] = local;
        }
        meshopt_optimizeVertexCache(local_.data(), local_.data(), local_.size(), names_.size());
        for (size_t i = 0; i < indices.size(); ++i) indices[i] = names_[local_[i]];
        for (uint32_t name : names_) localOf_[name] = kNone;
    }

private:
    static constexpr uint32_t kNone = ~0u;
    std::vector<uint32_t> localOf_, names_, local_;
};

std::vector<vec3> makeAxes(const std::vector<vec3>& normals) {
    std::vector<vec3> samples;
    const size_t step = std::max<size_t>(normals.size() / kSamples, 1);
    for (size_t t = 0; t < normals.size(); t += step)
        if (normals[t] != vec3(0)) samples.push_back(normals[t]);
    if (samples.empty()) return {};
    constexpr uint32_t kFewest = 6, kMost = FacingGroups::kMost - 1;  // one is for what has no
                                                                      // normal
    const uint32_t wanted = uint32_t(normals.size()) / kTrianglesPerGroup;
    std::vector<vec3> axes = firstAxes(samples, std::clamp(wanted, kFewest, kMost));
    settle(axes, samples);
    order(axes);
    return axes;
}

// Makes a group's cone of its triangles. What has no normal or more than a half-sphere of them is
// always seen.
void bound(FacingGroups& groups, uint32_t group, const vec3& wanted, std::span<const vec3> normals,
           std::span<const vec3> corners) {
    constexpr float kUnits = 127;
    const vec3 axis = glm::round(wanted * kUnits) / kUnits;
    const float length = glm::length(axis);
    float cosine = 1, least = 0;
    for (size_t i = 0; i < normals.size(); ++i) {
        cosine = std::min(cosine, glm::dot(normals[i], axis) / length);
        const float height = glm::dot(normals[i], corners[i] - groups.center);
        least = i == 0 ? height : std::min(least, height);
    }
    const float angle = std::acos(std::clamp(cosine, -1.0f, 1.0f)) + kConeMargin;
    groups.sine[group] = uint8_t(kUnits);
    groups.limit[group] = int8_t(-kUnits);
    if (!(length > 0) || angle >= kPi / 2 || !(groups.extent > 0)) return;
    for (int c = 0; c < 3; ++c)
        groups.axis[size_t(c)][group] = int8_t(std::lround(axis[c] * kUnits));
    groups.sine[group] = uint8_t(std::ceil(length * std::sin(angle) * kUnits));
    const float limit = length * std::cos(angle) * least / groups.extent - kPlaneMargin;
    groups.limit[group] = int8_t(std::floor(limit * kUnits));
}

}  // namespace

FacingGroups groupByFacing(std::span<const vec3> positions, std::span<uint32_t> indices) {
    FacingGroups groups;
    const std::vector<vec3> normals = Normals(positions, indices).of;
    const std::vector<vec3> axes = makeAxes(normals);
    vec3 low = positions[indices[0]], high = low;
    for (uint32_t index : indices) {
        low = glm::min(low, positions[index]);
        high = glm::max(high, positions[index]);
    }
    groups.center = (low + high) / 2.0f;
    groups.extent = glm::length(high - low);

    std::vector<std::vector<uint32_t>> members(axes.size() + 1);
    for (uint32_t t = 0; t < normals.size(); ++t)
        members[normals[t] == vec3(0) ? axes.size() : nearest(axes, normals[t])].push_back(t);
    const std::vector<uint32_t> before(indices.begin(), indices.end());
    CacheOrder cache(positions.size());
    uint32_t filled = 0;
    std::vector<vec3> own, corners;
    for (size_t k = 0; k < members.size(); ++k) {
        if (members[k].empty()) continue;
        own.clear();
        corners.clear();
        const uint32_t first = filled;
        for (uint32_t t : members[k]) {
            own.push_back(normals[t]);
            corners.push_back(positions[before[t * 3]]);
            for (uint32_t c = 0; c < 3; ++c) indices[filled++] = before[t * 3 + c];
        }
        cache.apply(indices.subspan(first, filled - first));
        groups.firstIndex[groups.count] = first;
        bound(groups, groups.count++, k < axes.size() ? axes[k] : vec3(0), own, corners);
    }
    groups.firstIndex[groups.count] = filled;
    return groups;
}

}  // namespace rushlight

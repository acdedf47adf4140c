#include "renderer/geometry/mesh_lods.h"

#include "renderer/geometry/lod_refit.h"
#include "renderer/geometry/mesh_topology.h"

#include <algorithm>

#include <meshoptimizer.h>

namespace rushlight {
namespace {

constexpr float kLeastGain = 0.85f;  // a level has at most this share of the triangles of the one
                                     // before
constexpr float kStuck = 0.6f;  // where collapses leave more, locked vertices keep them from going
                                // on
constexpr float kLargestError = 0.1f;  // of the mesh's extent

// Open surfaces that lose area, leaf cards above all, look thinner; closed ones only get rounder.
constexpr float kLeastAreaOpen = 0.85f, kLeastAreaClosed = 0.75f, kMostArea = 1.15f;

// Triangles and vertices whose distance is measured; more than these are taken at even steps.
constexpr size_t kSamples = 512;

// Balancing takes time with the triangles, and with the distance that is searched. Larger levels
// have small errors.
constexpr uint32_t kMostRefit = 2048;
constexpr float kRefitReach = 0.5f;  // of the largest error that a level may have

constexpr float kLeastMove = 0.02f;  // of a level's error; what moves less stays
constexpr uint32_t kNone = ~0u;

double doubleArea(std::span<const vec3> positions, std::span<const uint32_t> indices) {
    double area = 0;
    for (size_t i = 0; i < indices.size(); i += 3) {
        const vec3& a = positions[indices[i]];
        area += double(
            glm::length(glm::cross(positions[indices[i + 1]] - a, positions[indices[i + 2]] - a)));
    }
    return area;
}

// Positions with the same bits for all in one place, as meshoptimizer compares bits.
std::vector<vec3> shared(std::span<const vec3> positions, std::span<const uint32_t> places) {
    std::vector<uint32_t> first(places.size(), kNone);
    std::vector<vec3> out(positions.size());
    for (uint32_t v = 0; v < out.size(); ++v) {
        uint32_t& from = first[places[v]];
        if (from == kNone) from = v;
        out[v] = positions[from];
    }
    return out;
}

// Vertices that differ in the normal or the tangent's direction alone, one name for all of them.
class WeldedVertices {
public:
    WeldedVertices(const MeshDesc& mesh, std::span<const vec3> shared)
        : mesh_(mesh), next_(mesh.positions.size()) {
        std::vector<meshopt_Stream> streams;
        const auto add = [&](const auto& values) {
            if (!values.empty())
                streams.push_back({values.data(), sizeof values[0], sizeof values[0]});
        };
        add(shared);
        add(mesh.uv0);
        add(mesh.uv1);
        add(mesh.colors);
        if (!mesh.tangents.empty())
            streams.push_back({&mesh.tangents[0].w, sizeof(float), sizeof(vec4)});
        indices.resize(mesh.indices.size());
        meshopt_generateShadowIndexBufferMulti(indices.data(), mesh.indices.data(), indices.size(),
                                               mesh.positions.size(), streams.data(),
                                               streams.size());
        for (uint32_t v = 0; v < next_.size(); ++v) next_[v] = v;
        for (size_t i = 0; i < indices.size(); ++i) {
            const uint32_t vertex = mesh.indices[i], name = indices[i];
            if (vertex == name || next_[vertex] != vertex) continue;
            next_[vertex] = next_[name];
            next_[name] = vertex;
        }
    }

    /// Level 0 in names: each is one of the vertices it stands for.
    std::vector<uint32_t> indices;

    /// Replaces the names of a level by vertices whose normals face the way of their triangles.
    void pickVertices(std::span<uint32_t> level) const {
        for (size_t i = 0; i < level.size(); i += 3) {
            const vec3& a = mesh_.positions[level[i]];
            const vec3 normal = glm::cross(mesh_.positions[level[i + 1]] - a,
                                           mesh_.positions[level[i + 2]] - a);
            for (size_t k = 0; k < 3; ++k) level[i + k] = pick(level[i + k], normal);
        }
    }

private:
    uint32_t pick(uint32_t name, const vec3& normal) const {
        uint32_t best = name;
        float most = glm::dot(mesh_.normals[name], normal);
        for (uint32_t v = next_[name]; v != name; v = next_[v])
            if (const float along = glm::dot(mesh_.normals[v], normal); along > most)
                best = v, most = along;
        return best;
    }

    const MeshDesc& mesh_;
    std::vector<uint32_t> next_;  // of the same name, in a ring
};

// How far levels are from level 0: to a point of one belongs the nearest of the other that is
// shaded alike, so that a relief goes only when it is too small to be seen, however shallow it is.
// What meshoptimizer reports is the root of a mean square distance to planes, which may be a
// hundredth of the largest distance: a leaf that goes as a whole is in none of its own planes'
// errors.
class Deviation {
public:
    Deviation(const MeshDesc& mesh, const Aabb& bounds)
        : mesh_(mesh), bounds_(bounds), grid_(mesh.positions, mesh.normals, mesh.indices, bounds) {}

    /// Between `least` and `most`, with 10 % on top of what is measured for what is between the
    /// samples.
    float of(std::span<const vec3> positions, std::span<const vec3> normals,
             std::span<const uint32_t> level, float least, float most) const {
        constexpr float kMargin = 1.1f;
        const SurfaceGrid grid(positions, normals, level, bounds_);
        float largest = least / kMargin;
        const auto look = [&](const SurfaceGrid& at, const vec3& point, const vec3& normal) {
            largest = at.distance(point, normal, largest, most);
        };
        const std::span<const uint32_t> from = mesh_.indices;
        for (size_t i = 0; i < from.size(); i += step(from.size()))
            look(grid, mesh_.positions[from[i]], mesh_.normals[from[i]]);
        for (size_t t = 0; t < level.size() / 3; t += step(level.size() / 3)) {
            const uint32_t a = level[t * 3], b = level[t * 3 + 1], c = level[t * 3 + 2];
            const vec3 p = positions[a] + positions[b] + positions[c];
            const vec3 n = normals[a] + normals[b] + normals[c];
            look(grid_, p / 3.0f, n);
            for (uint32_t corner : {a, b, c}) {
                look(grid_, positions[corner], normals[corner]);
                look(grid_, (p - positions[corner]) / 2.0f, n - normals[corner]);
            }
        }
        return largest * kMargin;
    }

    const SurfaceGrid& original() const { return grid_; }

private:
    static size_t step(size_t count) { return std::max<size_t>(count / kSamples, 1); }

    const MeshDesc& mesh_;
    Aabb bounds_;
    SurfaceGrid grid_;
};

// One level: only the vertices it uses, as unused duplicates would count as seams and lock their
// neighbours.
class Level {
public:
    Level(std::span<const vec3> positions, std::span<const uint32_t> indices)
        : local_(indices.size()) {
        std::vector<uint32_t> localOf(positions.size(), kNone);
        for (size_t i = 0; i < indices.size(); ++i) {
            uint32_t& local = localOf[indices[i]];
            if (local == kNone) {
                local = uint32_t(names_.size());
                names_.push_back(indices[i]);
                positions_.push_back(positions[indices[i]]);
            }
            local_[i] = local;
        }
        scale_ = meshopt_simplifyScale(&positions_[0].x, positions_.size(), sizeof(vec3));
    }

    /// `error` becomes the root of a mean square distance to the planes of level 0, in metres.
    std::vector<uint32_t> simplify(bool cluster, size_t target, float errorLimit,
                                   float& error) const {
        std::vector<uint32_t> out(local_.size());
        const float* positions = &positions_[0].x;
        const size_t size = cluster
                                ? meshopt_simplifySloppy(out.data(), local_.data(), local_.size(),
                                                         positions, positions_.size(), sizeof(vec3),
                                                         target, errorLimit / scale_, &error)
                                : meshopt_simplify(out.data(), local_.data(), local_.size(),
                                                   positions, positions_.size(), sizeof(vec3),
                                                   target, errorLimit / scale_, 0, &error);
        out.resize(size);
        error *= scale_;
        meshopt_optimizeVertexCache(out.data(), out.data(), out.size(), positions_.size());
        for (uint32_t& index : out) index = names_[index];
        return out;
    }

private:
    std::vector<uint32_t> local_, names_;
    std::vector<vec3> positions_;
    float scale_ = 0;
};

class ChainMaker {
public:
    ChainMaker(const MeshDesc& mesh, bool closed, float extent)
        : mesh_(mesh),
          places_(placesOf(mesh.positions)),
          shared_(shared(mesh.positions, places_)),
          welded_(mesh, shared_),
          bounds_(boundsOf(mesh)),
          deviation_(mesh, bounds_),
          errorLimit_(kLargestError * extent),
          area_(doubleArea(mesh.positions, mesh.indices)),
          leastArea_(area_ * double(closed ? kLeastAreaClosed : kLeastAreaOpen)),
          seamed_(shared_, mesh.indices),
          original_(shared_, welded_.indices),
          current_(welded_.indices),
          localVertex_(mesh.positions.size(), kNone),
          localPlace_(mesh.positions.size(), kNone) {}

    void fill(LodChain& chain) {
        while (chain.count < kMaxLods && current_.size() / 6 >= kFewestTrianglesOfLod) {
            float error = chain.lods[chain.count - 1].error;
            if (!coarsen(error)) return;
            const MeshLod before = chain.lods[chain.count - 1];
            chain.lods[chain.count++] = {before.firstIndex + before.indexCount,
                                         uint32_t(current_.size()), error};
            std::vector<uint32_t> drawn = current_;
            refine(drawn, before.error, chain.lods[chain.count - 1].error, chain.moved);
            chain.indices.insert(chain.indices.end(), drawn.begin(), drawn.end());
        }
    }

private:
    static Aabb boundsOf(const MeshDesc& mesh) {
        Aabb bounds;
        for (const vec3& p : mesh.positions) bounds.grow(p);
        return bounds;
    }

    enum class Way : uint8_t { seams, welded, clusters };

    /// Makes of level 0 a level with half the triangles of `current_`: by collapsing edges, with
    /// hard edges as seams or welded, whichever deviates less; by clustering where locked vertices
    /// stop both.
    bool coarsen(float& error) {
        const size_t size = current_.size(), target = size / 6 * 3;
        std::vector<uint32_t> best;
        float bestError = errorLimit_;
        const auto attempt = [&](Way way) {
            float meanError = 0;
            const Level& from = way == Way::seams ? seamed_ : original_;
            auto made = from.simplify(way == Way::clusters, target, errorLimit_, meanError);
            if (!useful(made) || meanError >= bestError) return;
            if (way != Way::seams) welded_.pickVertices(made);
            const float newError = deviation_.of(mesh_.positions, mesh_.normals, made,
                                                 std::max(error, meanError), bestError);
            if (newError >= bestError) return;
            best = std::move(made);
            bestError = newError;
            clustered_ = way == Way::clusters;
        };
        if (!clustered_) {
            attempt(Way::seams);
            attempt(Way::welded);
        }
        if (best.empty() || float(best.size()) > kStuck * float(size)) attempt(Way::clusters);
        if (best.empty()) return false;
        error = bestError;
        current_ = std::move(best);
        return true;
    }

    /// Gives a level moved vertices where that lessens its error.
    void refine(std::vector<uint32_t>& level, float least, float& error,
                std::vector<MovedVertex>& moved) {
        if (level.size() > kMostRefit * 3) return;
        LevelSurface surface = surfaceOf(level);
        std::vector<vec3> offsets = refit(surface, deviation_.original(),
                                          std::min(error, kRefitReach * errorLimit_));
        for (vec3& offset : offsets)
            if (glm::length(offset) < kLeastMove * error) offset = vec3(0);
        for (size_t v = 0; v < surface.positions.size(); ++v)
            surface.positions[v] += offsets[surface.places[v]];
        const float newError = deviation_.of(surface.positions, surface.normals, surface.indices,
                                             least, error);
        if (newError >= error) return;
        error = newError;
        std::vector<uint32_t> names = surface.sources;
        for (size_t v = 0; v < names.size(); ++v) {
            const vec3& offset = offsets[surface.places[v]];
            if (offset == vec3(0)) continue;
            names[v] = uint32_t(mesh_.positions.size() + moved.size());
            moved.push_back({surface.sources[v], offset});
        }
        for (size_t i = 0; i < level.size(); ++i) level[i] = names[surface.indices[i]];
    }

    LevelSurface surfaceOf(std::span<const uint32_t> level) {
        LevelSurface out;
        const auto number = [](std::vector<uint32_t>& names, uint32_t name, uint32_t next) {
            if (names[name] == kNone) names[name] = next;
            return names[name];
        };
        for (uint32_t vertex : level) {
            const uint32_t local = number(localVertex_, vertex, uint32_t(out.sources.size()));
            out.indices.push_back(local);
            if (local < out.sources.size()) continue;
            const uint32_t place = number(localPlace_, places_[vertex], out.placeCount);
            out.placeCount = std::max(out.placeCount, place + 1);
            out.sources.push_back(vertex);
            out.places.push_back(place);
            out.positions.push_back(mesh_.positions[vertex]);
            out.normals.push_back(mesh_.normals[vertex]);
        }
        for (uint32_t vertex : out.sources) {
            localVertex_[vertex] = kNone;
            localPlace_[places_[vertex]] = kNone;
        }
        return out;
    }

    bool useful(std::span<const uint32_t> level) const {
        if (float(level.size()) > kLeastGain * float(current_.size()) ||
            level.size() < kFewestTrianglesOfLod * 3)
            return false;
        const double area = doubleArea(mesh_.positions, level);
        return area >= leastArea_ && area <= area_ * double(kMostArea);
    }

    const MeshDesc& mesh_;
    const std::vector<uint32_t> places_;
    const std::vector<vec3> shared_;
    const WeldedVertices welded_;
    const Aabb bounds_;
    const Deviation deviation_;
    const float errorLimit_;
    const double area_, leastArea_;
    const Level seamed_, original_;
    std::vector<uint32_t> current_;
    std::vector<uint32_t> localVertex_, localPlace_;  // kNone but while a surface is made
    bool clustered_ = false;  // the level before came from clustering: its topology is no more what
                              // collapses need
};

}  // namespace

LodChain makeLods(const MeshDesc& mesh, bool closed) {
    LodChain chain;
    chain.lods[0].indexCount = uint32_t(mesh.indices.size());
    if (mesh.indices.size() < kFewestTrianglesForLods * 3) return chain;
    const float extent = meshopt_simplifyScale(&mesh.positions[0].x, mesh.positions.size(),
                                               sizeof(vec3));
    // Squares of squares of lengths must be numbers.
    if (extent > 1e-5f && extent < 1e6f) ChainMaker(mesh, closed, extent).fill(chain);
    return chain;
}

}  // namespace rushlight

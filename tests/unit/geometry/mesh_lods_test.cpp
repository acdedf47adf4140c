#include "renderer/geometry/mesh_lods.h"

#include "renderer/geometry/mesh_topology.h"
#include "renderer/resources/geometry_store.h"
#include "tests/support/memory_device.h"
#include "tests/support/random.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/thread_jobs.h"

#include <gtest/gtest.h>

#include <set>

namespace rushlight {
namespace {

using Indices = std::span<const uint32_t>;

struct Mesh : Shape {
    std::vector<vec3> normals;
    std::vector<vec2> uv0;

    MeshDesc meshDesc() const {
        MeshDesc d = desc();
        d.normals = normals;
        d.uv0 = uv0;
        return d;
    }
    LodChain lods() const { return makeLods(meshDesc(), isClosed(positions, indices)); }
    /// With the vertices that the levels have beside the mesh's.
    Mesh with(const LodChain& chain) const {
        Mesh all = *this;
        for (const MovedVertex& v : chain.moved) {
            all.positions.push_back(positions[v.source] + v.offset);
            all.normals.push_back(normals[v.source]);
            if (!uv0.empty()) all.uv0.push_back(uv0[v.source]);
        }
        return all;
    }
    Indices level(const LodChain& chain, uint32_t lod) const {
        if (lod == 0) return indices;
        return Indices(chain.indices)
            .subspan(chain.lods[lod].firstIndex - indices.size(), chain.lods[lod].indexCount);
    }
};

// A unit sphere with a seam: the texture runs once around it.
Mesh sphere(uint32_t rings, uint32_t segments) {
    Mesh mesh{makeSphere(rings, segments), {}, {}};
    mesh.normals = mesh.positions;
    for (uint32_t r = 0; r <= rings; ++r)
        for (uint32_t s = 0; s <= segments; ++s)
            mesh.uv0.push_back({float(s) / float(segments), float(r) / float(rings)});
    return mesh;
}

// A square of 2 m, `bumps` metres high, its triangles with corners of their own and flat normals
// when `flat`.
Mesh terrain(uint32_t side, float bumps, bool flat = false) {
    Mesh mesh;
    const auto point = [&](uint32_t x, uint32_t z) {
        const vec2 p = vec2(float(x), float(z)) * (2 / float(side)) - 1.0f;
        return vec3(p.x, bumps * std::sin(5 * p.x) * std::cos(7 * p.y), p.y);
    };
    for (uint32_t z = 0; z <= side; ++z)
        for (uint32_t x = 0; x <= side; ++x) mesh.positions.push_back(point(x, z));
    for (uint32_t z = 0; z < side; ++z)
        for (uint32_t x = 0; x < side; ++x) {
            const uint32_t a = z * (side + 1) + x, b = a + side + 1;
            for (uint32_t i : {a, b, a + 1, a + 1, b, b + 1}) mesh.indices.push_back(i);
        }
    if (flat) {
        std::vector<vec3> corners;
        for (uint32_t& i : mesh.indices) {
            corners.push_back(mesh.positions[i]);
            i = uint32_t(corners.size() - 1);
        }
        mesh.positions = corners;
    }
    mesh.normals.resize(mesh.positions.size(), vec3(0));
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const vec3& a = mesh.positions[mesh.indices[i]];
        const vec3 n = glm::cross(mesh.positions[mesh.indices[i + 1]] - a,
                                  mesh.positions[mesh.indices[i + 2]] - a);
        for (size_t k = 0; k < 3; ++k) mesh.normals[mesh.indices[i + k]] += n;
    }
    for (vec3& n : mesh.normals) n = glm::normalize(n);
    return mesh;
}

// Cards of 10 cm, each a quad of its own, strewn over a ball of 2 m.
Mesh leaves(uint32_t count) {
    Mesh mesh;
    Random random(3);
    for (uint32_t i = 0; i < count; ++i) {
        const vec3 at = random.vector(-1, 1), u = random.direction() * 0.05f;
        const vec3 n = glm::normalize(glm::cross(u, random.direction())), v = glm::cross(n, u);
        const uint32_t first = uint32_t(mesh.positions.size());
        for (vec3 corner : {-u - v, u - v, u + v, v - u}) {
            mesh.positions.push_back(at + corner);
            mesh.normals.push_back(n);
            mesh.uv0.push_back({glm::dot(corner, u) > 0, glm::dot(corner, v) > 0});
        }
        for (uint32_t k : {0, 1, 2, 0, 2, 3}) mesh.indices.push_back(first + k);
    }
    return mesh;
}

float distanceToSegment(const vec3& p, const vec3& a, const vec3& b) {
    const float t = glm::clamp(glm::dot(p - a, b - a) / std::max(glm::dot(b - a, b - a), 1e-30f),
                               0.0f, 1.0f);
    return glm::length(p - a - t * (b - a));
}

// The plane where the foot of the perpendicular is inside, else the nearest edge.
float distanceToTriangle(const vec3& p, const vec3& a, const vec3& b, const vec3& c) {
    const vec3 n = glm::cross(b - a, c - a);
    const bool inside = glm::dot(glm::cross(b - a, p - a), n) >= 0 &&
                        glm::dot(glm::cross(c - b, p - b), n) >= 0 &&
                        glm::dot(glm::cross(a - c, p - c), n) >= 0;
    if (inside && glm::length(n) > 0) return std::abs(glm::dot(p - a, n)) / glm::length(n);
    return std::min(
        {distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
}

// The largest distance from points of `from` to the surface `to`.
float deviation(const Mesh& mesh, Indices from, Indices to) {
    Random random(1);
    float most = 0;
    for (int sample = 0; sample < 800; ++sample) {
        const size_t t = random.below(uint32_t(from.size() / 3)) * 3;
        const float u = std::sqrt(random.uniform(0, 1)), v = random.uniform(0, 1);
        const vec3 p = (1 - u) * mesh.positions[from[t]] +
                       u * (1 - v) * mesh.positions[from[t + 1]] +
                       u * v * mesh.positions[from[t + 2]];
        float least = 1e30f;
        for (size_t i = 0; i < to.size(); i += 3)
            least = std::min(least,
                             distanceToTriangle(p, mesh.positions[to[i]], mesh.positions[to[i + 1]],
                                                mesh.positions[to[i + 2]]));
        most = std::max(most, least);
    }
    return most;
}

double areaOf(const Mesh& mesh, Indices level) {
    double area = 0;
    for (size_t i = 0; i < level.size(); i += 3) {
        const vec3& a = mesh.positions[level[i]];
        area += 0.5 * double(glm::length(glm::cross(mesh.positions[level[i + 1]] - a,
                                                    mesh.positions[level[i + 2]] - a)));
    }
    return area;
}

// Counts fall to 85 % or less, errors never, indices are in range, nothing is left over.
void expectSound(const Mesh& mesh, const LodChain& chain) {
    ASSERT_GE(chain.count, 1u);
    ASSERT_LE(chain.count, kMaxLods);
    EXPECT_EQ(chain.lods[0].firstIndex, 0u);
    EXPECT_EQ(chain.lods[0].indexCount, mesh.indices.size());
    EXPECT_EQ(chain.lods[0].error, 0);
    for (uint32_t lod = 1; lod < chain.count; ++lod) {
        const MeshLod &before = chain.lods[lod - 1], &now = chain.lods[lod];
        EXPECT_EQ(now.firstIndex, before.firstIndex + before.indexCount) << lod;
        EXPECT_LE(float(now.indexCount), 0.85f * float(before.indexCount)) << lod;
        EXPECT_GE(now.indexCount, kFewestTrianglesOfLod * 3) << lod;
        EXPECT_EQ(now.indexCount % 3, 0u) << lod;
        EXPECT_GE(now.error, before.error) << lod;
    }
    const MeshLod& last = chain.lods[chain.count - 1];
    EXPECT_EQ(last.firstIndex + last.indexCount, mesh.indices.size() + chain.indices.size());
    for (uint32_t index : chain.indices)
        ASSERT_LT(index, mesh.positions.size() + chain.moved.size());
    for (const MovedVertex& v : chain.moved) ASSERT_LT(v.source, mesh.positions.size());
}

TEST(MeshLods, CountsHalveAndErrorsGrow) {
    for (const Mesh& mesh : {sphere(32, 64), terrain(40, 0.1f), terrain(24, 0.1f, true)}) {
        const LodChain chain = mesh.lods();
        expectSound(mesh, chain);
        ASSERT_GE(chain.count, 3u);
        for (uint32_t lod = 1; lod < std::min(chain.count, 5u); ++lod) {
            EXPECT_NEAR(double(chain.lods[lod].indexCount),
                        double(chain.lods[lod - 1].indexCount) / 2,
                        double(chain.lods[lod - 1].indexCount) * 0.1)
                << lod;
            EXPECT_GT(chain.lods[lod].error, chain.lods[lod - 1].error) << lod;
        }
    }
}

TEST(MeshLods, TheErrorBoundsTheDistanceBothWays) {
    for (const Mesh& mesh :
         {sphere(32, 64), terrain(40, 0.1f), terrain(24, 0.1f, true), leaves(200)}) {
        const LodChain chain = mesh.lods();
        const Mesh all = mesh.with(chain);
        for (uint32_t lod = 1; lod < chain.count; ++lod) {
            const Indices level = mesh.level(chain, lod);
            const float error = chain.lods[lod].error * 1.05f + 1e-6f;
            EXPECT_LE(deviation(all, level, mesh.indices), error) << lod;
            EXPECT_LE(deviation(all, mesh.indices, level), error) << lod;
        }
    }
}

TEST(MeshLods, TheErrorIsNoExaggeration) {
    const Mesh mesh = sphere(32, 64);
    const LodChain chain = mesh.lods();
    const Mesh all = mesh.with(chain);
    for (uint32_t lod = 1; lod < chain.count; ++lod)
        EXPECT_LT(chain.lods[lod].error, 5 * deviation(all, mesh.indices, mesh.level(chain, lod)))
            << lod;
}

TEST(MeshLods, AFlatPlaneCollapsesWithoutError) {
    const Mesh mesh = terrain(40, 0);
    const LodChain chain = mesh.lods();
    expectSound(mesh, chain);
    EXPECT_TRUE(chain.moved.empty());
    EXPECT_LE(chain.lods[chain.count - 1].indexCount, 60u * 3);
    EXPECT_LT(chain.lods[chain.count - 1].error, 1e-4f);
    EXPECT_NEAR(areaOf(mesh.with(chain), mesh.level(chain, chain.count - 1)), 4, 1e-4);
}

TEST(MeshLods, AClosedMeshStaysClosed) {
    const Mesh mesh = sphere(32, 64);
    const LodChain chain = mesh.lods();
    for (uint32_t lod = 0; lod < std::min(chain.count, 6u); ++lod)
        EXPECT_TRUE(isClosed(mesh.with(chain).positions, mesh.level(chain, lod))) << lod;
}

// Where u jumps from 1 to 0 the triangles of both sides end in the same places.
TEST(MeshLods, ASeamStaysShutAndTexturesDoNotSmearOverIt) {
    const Mesh mesh = sphere(32, 64);
    const LodChain chain = mesh.lods();
    const Mesh all = mesh.with(chain);
    for (uint32_t lod = 0; lod < std::min(chain.count, 5u); ++lod) {
        const Indices level = mesh.level(chain, lod);
        std::set<float> heights[2];
        for (size_t i = 0; i < level.size(); i += 3) {
            float low = 1, high = 0;
            for (size_t k = 0; k < 3; ++k) {
                const vec3& p = all.positions[level[i + k]];
                const float u = all.uv0[level[i + k]].x;
                if (std::abs(p.y) < 0.99f) low = std::min(low, u), high = std::max(high, u);
                if (u == 0 || u == 1) heights[u > 0.5f].insert(p.y);
            }
            EXPECT_LT(high - low, 0.6f) << "level " << lod << ": a triangle across the seam";
        }
        EXPECT_EQ(heights[0], heights[1]) << "level " << lod;
        EXPECT_FALSE(heights[0].empty()) << "level " << lod;
    }
}

TEST(MeshLods, TrianglesTakeTheNormalsOfTheirSide) {
    const Mesh flat = terrain(24, 0.1f, true);
    const LodChain chain = flat.lods();
    const Mesh mesh = flat.with(chain);
    for (uint32_t lod = 1; lod < 3; ++lod) {
        const Indices level = flat.level(chain, lod);
        double away = 0;
        for (size_t i = 0; i < level.size(); i += 3) {
            const vec3& a = mesh.positions[level[i]];
            const vec3 n = glm::normalize(
                glm::cross(mesh.positions[level[i + 1]] - a, mesh.positions[level[i + 2]] - a));
            for (size_t k = 0; k < 3; ++k)
                away += 1 - double(glm::dot(n, mesh.normals[level[i + k]]));
        }
        EXPECT_LT(away / double(level.size()), 0.02) << lod;
    }
}

TEST(MeshLods, LeafCardsKeepTheirArea) {
    const Mesh mesh = leaves(300);
    const LodChain chain = mesh.lods();
    expectSound(mesh, chain);
    const double area = areaOf(mesh, mesh.indices);
    for (uint32_t lod = 1; lod < chain.count; ++lod)
        EXPECT_GE(areaOf(mesh.with(chain), mesh.level(chain, lod)), 0.85 * area) << lod;
}

// Its mean distance from the centre.
double meanRadius(const Mesh& mesh, Indices level) {
    Random random(2);
    double sum = 0, area = 0;
    for (size_t i = 0; i < level.size(); i += 3) {
        const vec3 &a = mesh.positions[level[i]], &b = mesh.positions[level[i + 1]],
                   &c = mesh.positions[level[i + 2]];
        const double weight = double(glm::length(glm::cross(b - a, c - a)));
        for (int k = 0; k < 16; ++k) {
            const float u = std::sqrt(random.uniform(0, 1)), v = random.uniform(0, 1);
            const vec3 p = (1 - u) * a + u * (1 - v) * b + u * v * c;
            sum += weight * double(glm::length(p));
            area += weight;
        }
    }
    return sum / area;
}

// Chords of a sphere run inside it; balanced ones are as often outside.
TEST(MeshLods, RoundThingsDoNotShrink) {
    const Mesh mesh = sphere(24, 48);
    const LodChain chain = mesh.lods();
    const Mesh all = mesh.with(chain);
    std::vector<uint32_t> unmoved = chain.indices;
    for (uint32_t& v : unmoved)
        if (v >= mesh.positions.size()) v = chain.moved[v - mesh.positions.size()].source;
    const double radius = meanRadius(mesh, mesh.indices);
    for (uint32_t lod = 1; lod < 4; ++lod) {
        const auto before = Indices(unmoved).subspan(
            chain.lods[lod].firstIndex - mesh.indices.size(), chain.lods[lod].indexCount);
        const double shrunk = radius - meanRadius(mesh, before),
                     balanced = radius - meanRadius(all, mesh.level(chain, lod));
        EXPECT_GT(shrunk, 0) << lod;
        EXPECT_LT(std::abs(balanced), 0.2 * shrunk) << lod;
    }
}

TEST(MeshLods, VerticesThatMoveKeepTheirPlaceTogether) {
    const Mesh mesh = sphere(24, 48);
    const LodChain chain = mesh.lods();
    ASSERT_FALSE(chain.moved.empty());
    for (uint32_t lod = 1; lod < chain.count; ++lod) {
        std::set<std::array<float, 3>> sources, places;  // as many of the one as of the other
        const Mesh all = mesh.with(chain);
        for (uint32_t v : mesh.level(chain, lod)) {
            const uint32_t source = v < mesh.positions.size()
                                        ? v
                                        : chain.moved[v - mesh.positions.size()].source;
            const vec3 &from = mesh.positions[source], &to = all.positions[v];
            sources.insert({from.x, from.y, from.z});
            places.insert({to.x, to.y, to.z});
        }
        EXPECT_EQ(sources.size(), places.size()) << lod;
    }
}

TEST(MeshLods, OpenBordersStay) {
    const Mesh mesh = terrain(40, 0.1f);
    const LodChain chain = mesh.lods();
    ASSERT_FALSE(chain.moved.empty());
    for (const MovedVertex& v : chain.moved) {
        const vec3& p = mesh.positions[v.source];
        EXPECT_LT(std::max(std::abs(p.x), std::abs(p.z)), 1);
    }
}

// Where a turned outline closes, sin 0 and sin 2π differ by a few bits: that is a seam and no open
// border.
TEST(MeshLods, PlacesThatDifferByRoundingAreOne) {
    const Mesh exact = sphere(24, 48);
    Mesh rounded = exact;
    for (size_t v = 0; v < rounded.positions.size(); ++v)
        if (rounded.uv0[v].x == 1) rounded.positions[v].z -= 1e-7f;
    ASSERT_TRUE(isClosed(rounded.positions, rounded.indices));
    const LodChain a = exact.lods(), b = rounded.lods();
    ASSERT_EQ(a.count, b.count);
    for (uint32_t lod = 1; lod < a.count; ++lod) {
        EXPECT_EQ(a.lods[lod].indexCount, b.lods[lod].indexCount) << lod;
        EXPECT_NEAR(a.lods[lod].error, b.lods[lod].error, 0.02f * a.lods[lod].error) << lod;
    }
}

TEST(MeshLods, SmallMeshesHaveNoChain) {
    Mesh cube{makeCube(), {}, {}};
    cube.normals.assign(cube.positions.size(), vec3(0, 1, 0));
    EXPECT_EQ(cube.lods().count, 1u);
    EXPECT_TRUE(cube.lods().indices.empty());
}

TEST(MeshLods, DegenerateInputIsSurvived) {
    const Mesh good = terrain(16, 0.1f);
    const auto spoiled = [&](auto&& spoil) {
        Mesh mesh = good;
        spoil(mesh);
        const LodChain chain = mesh.lods();
        expectSound(mesh, chain);
        for (uint32_t i = 0; i < chain.count; ++i) EXPECT_TRUE(std::isfinite(chain.lods[i].error));
    };
    spoiled([](Mesh& m) { std::fill(m.positions.begin(), m.positions.end(), vec3(1)); });
    spoiled([](Mesh& m) {
        for (vec3& p : m.positions) p = vec3(p.x, 0, 0);
    });
    spoiled([](Mesh& m) { std::fill(m.indices.begin(), m.indices.end(), 7u); });
    spoiled([](Mesh& m) {
        for (size_t i = 0; i < m.indices.size(); i += 2) m.indices[i] = m.indices[0];
    });
    spoiled([](Mesh& m) {
        for (vec3& p : m.positions) p *= 1e30f;
    });
    spoiled([](Mesh& m) {
        for (vec3& p : m.positions) p *= 1e-30f;
    });
    spoiled([](Mesh& m) {  // every triangle three times, once of them turned round
        const std::vector<uint32_t> once = m.indices;
        m.indices.insert(m.indices.end(), once.begin(), once.end());
        m.indices.insert(m.indices.end(), once.rbegin(), once.rend());
    });
    Random random(5);
    spoiled([&](Mesh& m) {
        for (uint32_t& i : m.indices) i = random.below(uint32_t(m.positions.size()));
    });
}

class StoredLods : public testing::Test {
protected:
    MemoryDevice device;
    GeometryStore store{device};

    vec3 drawn(const GpuMesh& gpu, uint32_t vertex) {
        return device.read<vec3>(store.streams(false).positions, gpu.firstVertex + vertex);
    }
    static std::vector<std::array<float, 3>> sorted(std::span<const vec3> places) {
        std::vector<std::array<float, 3>> out;
        for (const vec3& p : places) out.push_back({p.x, p.y, p.z});
        std::ranges::sort(out);
        return out;
    }
    std::vector<std::array<float, 3>> allDrawn(const GpuMesh& gpu) {
        std::vector<vec3> places;
        for (uint32_t v = 0; v < gpu.vertexCount + gpu.movedCount; ++v)
            places.push_back(drawn(gpu, v));
        return sorted(places);
    }
    std::vector<uint32_t> stored(const MeshLod& lod) {
        std::vector<uint32_t> indices(lod.indexCount);
        for (size_t i = 0; i < indices.size(); ++i)
            indices[i] = device.read<uint32_t>(store.indices(), lod.firstIndex + i);
        return indices;
    }
};

TEST_F(StoredLods, LevelsFollowLevelZeroInTheSharedBuffer) {
    const Mesh mesh = sphere(16, 32);
    (void)store.create(makeCube().desc());
    const GpuMesh& gpu = *store.find(*store.create(mesh.meshDesc()));
    const LodChain chain = mesh.lods();
    const std::vector<vec3> vertices = mesh.with(chain).positions;
    ASSERT_EQ(gpu.lodCount, chain.count);
    EXPECT_EQ(gpu.lods[0].indexCount, gpu.indexCount);
    ASSERT_EQ(gpu.groupedLods, 3u) << "of 1,024, 512 and 256 triangles";
    const uint32_t first = gpu.firstIndex + gpu.indexCount;  // after level 0 as it was given
    for (uint32_t lod = 0; lod < chain.count; ++lod) {
        std::vector<vec3> corners, wanted;
        for (uint32_t index : stored(gpu.lods[lod])) corners.push_back(drawn(gpu, index));
        for (uint32_t index : mesh.level(chain, lod)) wanted.push_back(vertices[index]);
        if (lod < gpu.groupedLods)
            EXPECT_EQ(sorted(corners), sorted(wanted)) << lod;
        else
            EXPECT_EQ(corners, wanted) << lod;
        EXPECT_EQ(gpu.lods[lod].firstIndex, first + chain.lods[lod].firstIndex);
        EXPECT_EQ(gpu.lods[lod].error, chain.lods[lod].error);
    }
}

TEST_F(StoredLods, ADestroyedChainsPlaceIsUsedAgain) {
    const Mesh mesh = sphere(16, 32);
    const MeshHandle first = *store.create(mesh.meshDesc());
    const GpuMesh before = *store.find(first);
    (void)store.create(makeCube().desc());
    store.destroy(first);
    const GpuMesh after = *store.find(*store.create(mesh.meshDesc()));
    EXPECT_EQ(after.firstIndex, before.firstIndex);
    EXPECT_EQ(after.firstVertex, before.firstVertex);
}

TEST_F(StoredLods, VerticesOfTheLevelsCollideWithNoOther) {
    const Mesh mesh = sphere(16, 32);
    const GpuMesh a = *store.find(*store.create(mesh.meshDesc()));
    const GpuMesh b = *store.find(*store.create(mesh.meshDesc()));
    ASSERT_GT(a.movedCount, 0u);
    EXPECT_EQ(b.firstVertex, a.firstVertex + a.vertexCount + a.movedCount);
    for (uint32_t v = 0; v < a.vertexCount + a.movedCount; ++v) {
        EXPECT_EQ(drawn(a, v), drawn(b, v));
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(drawn(a, v), a.bounds.low)) &&
                    glm::all(glm::lessThanEqual(drawn(a, v), a.bounds.high)))
            << v;
    }
}

TEST_F(StoredLods, CanBeLeftOut) {
    const Shape sphere = makeSphere(16, 32);
    MeshDesc desc = sphere.desc();
    desc.lods = false;
    EXPECT_EQ(store.find(*store.create(desc))->lodCount, 1u);
}

TEST_F(StoredLods, ABatchIsAsTheSameMeshesOneByOne) {
    const std::vector<Mesh> meshes = {sphere(16, 32), terrain(30, 0.1f), leaves(50), sphere(4, 4)};
    std::vector<MeshDesc> descs;
    for (const Mesh& mesh : meshes) descs.push_back(mesh.meshDesc());
    std::vector<MeshHandle> handles(descs.size());
    ThreadJobs jobs(3);
    ASSERT_TRUE(store.create(descs, handles, jobs));
    for (size_t i = 0; i < meshes.size(); ++i) {
        const GpuMesh batched = *store.find(handles[i]),
                      alone = *store.find(*store.create(descs[i]));
        ASSERT_EQ(batched.lodCount, alone.lodCount);
        for (uint32_t lod = 0; lod < alone.lodCount; ++lod)
            EXPECT_EQ(stored(batched.lods[lod]), stored(alone.lods[lod]));
    }
}

TEST_F(StoredLods, ABatchWithABadMeshMakesNone) {
    std::vector<MeshDesc> descs(3, MeshDesc{});
    const Shape cube = makeCube();
    descs[0] = cube.desc(), descs[1] = cube.desc("barrel"), descs[2] = cube.desc();
    descs[1].indices = {};
    std::vector<MeshHandle> handles(3);
    SerialJobs jobs;
    const auto made = store.create(descs, handles, jobs);
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().text().find("barrel"), std::string::npos);
    EXPECT_TRUE(store.changedMeshes().empty());
}

TEST_F(StoredLods, TheCpuHasTheSmallLevels) {
    const Mesh mesh = sphere(40, 80);  // 6,400 triangles: levels 2 and up have 2,048 at most
    const MeshHandle handle = *store.create(mesh.meshDesc());
    const GpuMesh& gpu = *store.find(handle);
    const LodChain chain = mesh.lods();
    const auto expectSame = [&] {
        const CpuMesh* cpu = store.cpuMesh(handle);
        ASSERT_NE(cpu, nullptr);
        EXPECT_EQ(cpu->firstLod, 2u);
        ASSERT_EQ(cpu->lodCount, gpu.lodCount);
        for (uint32_t lod = cpu->firstLod; lod < gpu.lodCount; ++lod) {
            const std::vector<uint32_t> indices = stored(gpu.lods[lod]);
            const auto level = cpu->level(lod);
            ASSERT_EQ(level.size(), indices.size());
            std::vector<vec3> held, shown;
            for (size_t i = 0; i < level.size(); ++i) {
                held.push_back(cpu->positions[level[i]]);
                shown.push_back(drawn(gpu, indices[i]));
            }
            ASSERT_EQ(sorted(held), sorted(shown));
        }
        EXPECT_LT(cpu->positions.size(), mesh.positions.size() + chain.moved.size())
            << "vertices that no kept level uses";
    };
    expectSame();
    ASSERT_FALSE(chain.moved.empty());
    EXPECT_EQ(allDrawn(gpu), sorted(mesh.with(chain).positions));
    Mesh moved = mesh;
    for (vec3& p : moved.positions) p = p * 2.0f + vec3(1, 0, 0);
    ASSERT_TRUE(store.update(handle, moved.meshDesc()));
    EXPECT_EQ(gpu.lodCount, store.find(handle)->lodCount) << "an update keeps the chain";
    expectSame();
    std::vector<vec3> wanted = moved.positions;
    for (const MovedVertex& v : chain.moved) wanted.push_back(moved.positions[v.source]);
    EXPECT_EQ(allDrawn(gpu), sorted(wanted));
    store.destroy(handle);
    EXPECT_EQ(store.cpuMesh(handle), nullptr);
}

TEST_F(StoredLods, ALargeMeshWithoutLevelsIsNotOnTheCpu) {
    const Shape sphere = makeSphere(40, 80);
    MeshDesc desc = sphere.desc();
    desc.lods = false;
    EXPECT_EQ(store.cpuMesh(*store.create(desc)), nullptr);
    EXPECT_NE(store.cpuMesh(*store.create(makeCube().desc())), nullptr);
}

TEST_F(StoredLods, ChangesAreListedOnce) {
    const Shape cube = makeCube();
    const MeshHandle a = *store.create(cube.desc()), b = *store.create(cube.desc());
    const auto changed = [&] {
        const auto span = store.changedMeshes();
        return std::vector<MeshHandle>(span.begin(), span.end());
    };
    EXPECT_EQ(changed(), (std::vector{a, b}));
    store.clearChanges();
    EXPECT_TRUE(changed().empty());
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(store.update(b, cube.desc()));
    EXPECT_EQ(changed(), std::vector{b});
    store.clearChanges();
    store.destroy(a);
    const MeshHandle again = *store.create(cube.desc());
    EXPECT_EQ(changed(), (std::vector{a, again})) << "one slot, two meshes";
}

}  // namespace
}  // namespace rushlight

#include "renderer/resources/geometry_store.h"

#include "renderer/geometry/mesh_topology.h"
#include "renderer/geometry/vertex_packing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <meshoptimizer.h>

namespace rushlight {
namespace {

constexpr uint32_t kFirstVertexCapacity = 1u << 16;
constexpr uint32_t kFirstIndexCapacity = 1u << 18;
constexpr uint32_t kMaxVertices = 1u << 28;

std::string countText(size_t n) { return std::to_string(n); }

Result<void> checkAttribute(const MeshDesc& desc, const char* name, size_t count) {
    if (count == 0 || count == desc.positions.size()) return {};
    return fail("mesh '" + std::string(desc.label) + "'",
                std::string(name) + " has " + countText(count) + " elements but positions has " +
                    countText(desc.positions.size()) + ".",
                ErrorKind::wrongUse);
}

Result<void> check(const MeshDesc& desc) {
    const std::string object = "mesh '" + std::string(desc.label) + "'";
    if (desc.positions.empty() || desc.positions.size() > kMaxVertices)
        return fail(object, "it has " + countText(desc.positions.size()) +
                                " vertices; 1 to 268,435,456 are possible.");
    if (desc.indices.empty() || desc.indices.size() % 3 != 0)
        return fail(object, "it has " + countText(desc.indices.size()) +
                                " indices; a positive multiple of three is needed.");
    for (uint32_t index : desc.indices)
        if (index >= desc.positions.size())
            return fail(object, "the index " + countText(index) + " is not below the " +
                                    countText(desc.positions.size()) + " vertices.");
    for (const vec3& p : desc.positions)
        if (!std::isfinite(p.x + p.y + p.z)) return fail(object, "a position is not finite.");
    if (auto ok = checkAttribute(desc, "normals", desc.normals.size()); !ok) return ok;
    if (auto ok = checkAttribute(desc, "tangents", desc.tangents.size()); !ok) return ok;
    if (auto ok = checkAttribute(desc, "uv0", desc.uv0.size()); !ok) return ok;
    if (auto ok = checkAttribute(desc, "uv1", desc.uv1.size()); !ok) return ok;
    return checkAttribute(desc, "colors", desc.colors.size());
}

// Area-weighted vertex normals, for meshes that come with none.
std::vector<vec3> makeNormals(const MeshDesc& desc) {
    std::vector<vec3> normals(desc.positions.size(), vec3(0));
    for (size_t i = 0; i < desc.indices.size(); i += 3) {
        const uint32_t a = desc.indices[i], b = desc.indices[i + 1], c = desc.indices[i + 2];
        const vec3 n = glm::cross(desc.positions[b] - desc.positions[a],
                                  desc.positions[c] - desc.positions[a]);
        for (uint32_t v : {a, b, c}) normals[v] += n;
    }
    for (vec3& n : normals) {
        const float length = glm::length(n);
        n = length > 0 ? n / length : vec3(0, 1, 0);
    }
    return normals;
}

uint16_t toUnorm16(float x) { return uint16_t(std::lround(std::clamp(x, 0.0f, 1.0f) * 65535)); }

}  // namespace

GeometryStore::~GeometryStore() {
    for (const Family& family : families_) {
        if (family.streams.positions) device_.destroy(family.streams.positions);
        if (family.streams.surfaces) device_.destroy(family.streams.surfaces);
        if (family.streams.extras) device_.destroy(family.streams.extras);
    }
    if (indices_) device_.destroy(indices_);
}

// What can be made of a description on any thread.
struct GeometryStore::Prepared {
    GpuMesh mesh;  // with no place yet
    std::vector<vec3> madeNormals;
    LodChain chain;
    CpuMesh cpu;
    std::vector<FacingGroups> facing;  // of the finest levels
    std::vector<uint32_t> indices;     // level 0 as it was given
    std::vector<uint32_t> finest;      // level 0 sorted by facing; empty: as it was given
    std::vector<uint32_t> places;      // of the vertices in the streams
};

namespace {

// Sorts the larger levels by facing. Level 0 gets a copy: what is blended depends on the order that
// it was given in.
void sortByFacing(const MeshDesc& desc, LodChain& chain, std::vector<uint32_t>& finest,
                  std::vector<FacingGroups>& facing) {
    if (desc.indices.size() < kFewestTrianglesForFacing * 3) return;
    finest.assign(desc.indices.begin(), desc.indices.end());
    std::vector<vec3> positions(desc.positions.begin(), desc.positions.end());
    for (const MovedVertex& v : chain.moved) positions.push_back(positions[v.source] + v.offset);
    for (uint32_t i = 0; i < chain.count; ++i) {
        const MeshLod& lod = chain.lods[i];
        if (lod.indexCount < kFewestTrianglesForFacing * 3) return;
        facing.push_back(groupByFacing(
            positions, i == 0 ? std::span(finest)
                              : std::span(chain.indices)
                                    .subspan(lod.firstIndex - finest.size(), lod.indexCount)));
    }
}

// Vertices in the order in which the levels use them first, the finest first, so that they are
// fetched in runs.
std::vector<uint32_t> fetchOrder(std::span<const uint32_t> finest, std::span<const uint32_t> levels,
                                 size_t vertexCount) {
    std::vector<uint32_t> used(finest.begin(), finest.end());
    used.insert(used.end(), levels.begin(), levels.end());
    std::vector<uint32_t> places(vertexCount);
    size_t next = meshopt_optimizeVertexFetchRemap(places.data(), used.data(), used.size(),
                                                   vertexCount);
    for (uint32_t& place : places)
        if (place == ~0u) place = uint32_t(next++);
    return places;
}

}  // namespace

GeometryStore::Prepared GeometryStore::prepare(const MeshDesc& desc) {
    Prepared out;
    GpuMesh& mesh = out.mesh;
    mesh.extended = !desc.uv1.empty() || !desc.colors.empty();
    mesh.hasTangents = !desc.tangents.empty();
    mesh.vertexCount = uint32_t(desc.positions.size());
    mesh.indexCount = uint32_t(desc.indices.size());
    for (const vec3& p : desc.positions) mesh.bounds.grow(p);
    mesh.closed = isClosed(desc.positions, desc.indices);
    MeshDesc withNormals = desc;
    if (desc.normals.empty()) withNormals.normals = out.madeNormals = makeNormals(desc);
    if (desc.lods) {
        out.chain = makeLods(withNormals, mesh.closed);
    } else {
        out.chain.lods[0].indexCount = mesh.indexCount;
    }
    mesh.movedCount = uint32_t(out.chain.moved.size());
    for (const MovedVertex& v : out.chain.moved)
        mesh.bounds.grow(desc.positions[v.source] + v.offset);
    out.cpu = makeCpuMesh(desc.positions, desc.indices, out.chain);
    sortByFacing(desc, out.chain, out.finest, out.facing);
    out.indices.assign(desc.indices.begin(), desc.indices.end());
    out.places = fetchOrder(out.finest.empty() ? out.indices : out.finest, out.chain.indices,
                            mesh.vertexCount + mesh.movedCount);
    for (auto* indices : {&out.indices, &out.finest, &out.chain.indices})
        for (uint32_t& index : *indices) index = out.places[index];
    return out;
}

Result<MeshHandle> GeometryStore::insert(Prepared&& prepared, const MeshDesc& desc) {
    GpuMesh& mesh = prepared.mesh;
    const LodChain& chain = prepared.chain;
    mesh.firstVertex = families_[mesh.extended].vertices.allocate(mesh.vertexCount +
                                                                  mesh.movedCount);
    const size_t indexCount = desc.indices.size() + prepared.finest.size() + chain.indices.size();
    mesh.firstIndex = indexRanges_.allocate(uint32_t(indexCount));
    mesh.lods = chain.lods;
    mesh.lodCount = chain.count;
    mesh.groupedLods = uint32_t(prepared.facing.size());
    mesh.facing = prepared.facing.data();
    for (uint32_t i = 0; i < chain.count; ++i)
        mesh.lods[i].firstIndex += mesh.firstIndex + uint32_t(prepared.finest.size());
    auto room = reserveVertices(mesh.extended);
    if (room) room = reserveIndices();
    if (!room) {
        families_[mesh.extended].vertices.release(mesh.firstVertex,
                                                  mesh.vertexCount + mesh.movedCount);
        indexRanges_.release(mesh.firstIndex, uint32_t(indexCount));
        return tl::unexpected(room.error());
    }
    MeshDesc withNormals = desc;
    if (desc.normals.empty()) withNormals.normals = prepared.madeNormals;
    upload(mesh, withNormals, chain.moved, prepared.places);
    device_.write(indices_, uint64_t(mesh.firstIndex) * 4,
                  std::as_bytes(std::span(prepared.indices)));
    if (!prepared.finest.empty())
        device_.write(indices_, uint64_t(mesh.lods[0].firstIndex) * 4,
                      std::as_bytes(std::span(prepared.finest)));
    if (!chain.indices.empty())
        device_.write(indices_, uint64_t(mesh.lods[1].firstIndex) * 4,
                      std::as_bytes(std::span(chain.indices)));
    const MeshHandle handle = meshes_.insert(mesh);
    if (sides_.size() <= handle.index()) sides_.resize(handle.index() + 1);
    sides_[handle.index()] = {std::move(prepared.cpu), std::move(prepared.chain.moved),
                              std::move(prepared.facing), std::move(prepared.places), false};
    noteChange(handle);
    return handle;
}

Result<MeshHandle> GeometryStore::create(const MeshDesc& desc) {
    if (auto ok = check(desc); !ok) return tl::unexpected(ok.error());
    return insert(prepare(desc), desc);
}

Result<void> GeometryStore::create(std::span<const MeshDesc> descs, std::span<MeshHandle> handles,
                                   JobSystem& jobs) {
    if (descs.size() != handles.size())
        return fail("meshes",
                    "there are " + countText(descs.size()) + " descriptions but room for " +
                        countText(handles.size()) + " handles.",
                    ErrorKind::wrongUse);
    for (const MeshDesc& desc : descs)
        if (auto ok = check(desc); !ok) return ok;
    std::vector<Prepared> prepared(descs.size());
    jobs.forRanges(uint32_t(descs.size()), 1, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) prepared[i] = prepare(descs[i]);
    });
    for (size_t i = 0; i < descs.size(); ++i) {
        const auto made = insert(std::move(prepared[i]), descs[i]);
        prepared[i] = {};
        if (!made) {
            for (size_t k = 0; k < i; ++k) destroy(std::exchange(handles[k], {}));
            return tl::unexpected(made.error());
        }
        handles[i] = *made;
    }
    return {};
}

Result<void> GeometryStore::update(MeshHandle handle, const MeshDesc& desc) {
    GpuMesh* mesh = meshes_.find(handle);
    if (!mesh)
        return fail("mesh '" + std::string(desc.label) + "'", "the handle is stale or none.",
                    ErrorKind::wrongUse);
    if (auto ok = check(desc); !ok) return ok;
    if (desc.positions.size() != mesh->vertexCount)
        return fail("mesh '" + std::string(desc.label) + "'",
                    "an update has " + countText(desc.positions.size()) +
                        " vertices but the mesh has " + countText(mesh->vertexCount) + ".",
                    ErrorKind::wrongUse);
    mesh->bounds = {};
    for (const vec3& p : desc.positions) mesh->bounds.grow(p);
    mesh->closed = false;  // vertices that were in one place may have parted; to check costs more
                           // than it saves
    mesh->groupedLods = 0;
    Side& side = sides_[handle.index()];
    for (MovedVertex& v : side.moved) v.offset = vec3(0);
    upload(*mesh, desc, side.moved, side.places);
    side.cpu.movePositions(desc.positions);
    noteChange(handle);
    return {};
}

void GeometryStore::destroy(MeshHandle handle) {
    const GpuMesh* mesh = meshes_.find(handle);
    if (!mesh) return;
    families_[mesh->extended].vertices.release(mesh->firstVertex,
                                               mesh->vertexCount + mesh->movedCount);
    const MeshLod& last = mesh->lods[mesh->lodCount - 1];
    indexRanges_.release(mesh->firstIndex, last.firstIndex + last.indexCount - mesh->firstIndex);
    noteChange(handle);
    meshes_.erase(handle);
    sides_[handle.index()] = {};
}

const CpuMesh* GeometryStore::cpuMesh(MeshHandle handle) const {
    if (!meshes_.find(handle)) return nullptr;
    const CpuMesh& cpu = sides_[handle.index()].cpu;
    return cpu.lodCount > 0 ? &cpu : nullptr;
}

void GeometryStore::noteChange(MeshHandle handle) {
    if (!std::exchange(sides_[handle.index()].changed, true)) changes_.push_back(handle);
}

void GeometryStore::clearChanges() {
    for (MeshHandle handle : changes_) sides_[handle.index()].changed = false;
    changes_.clear();
}

void GeometryStore::upload(const GpuMesh& mesh, const MeshDesc& desc,
                           std::span<const MovedVertex> moved, std::span<const uint32_t> places) {
    std::vector<vec3> made;
    std::span<const vec3> normals = desc.normals;
    if (normals.empty()) normals = made = makeNormals(desc);

    const VertexStreams& streams = families_[mesh.extended].streams;
    // The mesh's vertices and those that follow them.
    const auto write = [&](BufferHandle stream, auto&& valueOf) {
        std::vector<decltype(valueOf(0u))> values(mesh.vertexCount + moved.size());
        for (uint32_t i = 0; i < mesh.vertexCount; ++i) values[places[i]] = valueOf(i);
        for (size_t i = 0; i < moved.size(); ++i) {
            auto& value = values[places[mesh.vertexCount + i]] = values[places[moved[i].source]];
            if constexpr (std::is_same_v<decltype(valueOf(0u)), vec3>) value += moved[i].offset;
        }
        device_.write(stream, uint64_t(mesh.firstVertex) * sizeof values[0],
                      std::as_bytes(std::span(values)));
    };
    static_assert(sizeof(VertexPosition) == sizeof(vec3));
    write(streams.positions, [&](uint32_t i) { return desc.positions[i]; });
    write(streams.surfaces, [&](uint32_t i) {
        return VertexSurface{
            packTangentFrame(normals[i], desc.tangents.empty() ? vec4(0) : desc.tangents[i]),
            desc.uv0.empty() ? vec2(0) : desc.uv0[i]};
    });
    if (!mesh.extended) return;
    write(streams.extras, [&](uint32_t i) {
        VertexExtra extra;
        extra.uv1 = desc.uv1.empty() ? vec2(0) : desc.uv1[i];
        const vec4 color = desc.colors.empty() ? vec4(1) : desc.colors[i];
        for (int c = 0; c < 4; ++c) extra.color[size_t(c)] = toUnorm16(color[c]);
        return extra;
    });
}

Result<void> GeometryStore::grow(BufferHandle& buffer, const char* label, BufferUsage usage,
                                 uint64_t oldBytes, uint64_t newBytes) {
    auto larger = device_.createBuffer({label, newBytes, usage});
    if (!larger) return tl::unexpected(larger.error());
    if (buffer) {
        device_.copy(buffer, *larger, oldBytes);
        device_.destroy(buffer);
    }
    buffer = *larger;
    return {};
}

Result<void> GeometryStore::reserveVertices(bool extended) {
    Family& family = families_[extended];
    const uint64_t old = family.capacity;
    if (family.vertices.end() <= old) return {};
    const uint64_t capacity = std::max<uint64_t>(
        {kFirstVertexCapacity, old * 2, family.vertices.end()});
    const auto usage = BufferUsage::vertex;
    VertexStreams& s = family.streams;
    const auto one = [&](BufferHandle& buffer, const char* label, uint64_t stride) {
        return grow(buffer, label, usage, old * stride, capacity * stride);
    };
    if (auto ok = one(s.positions, extended ? "positions (extended)" : "positions",
                      sizeof(VertexPosition));
        !ok)
        return ok;
    if (auto ok = one(s.surfaces, extended ? "surfaces (extended)" : "surfaces",
                      sizeof(VertexSurface));
        !ok)
        return ok;
    if (extended)
        if (auto ok = one(s.extras, "extras", sizeof(VertexExtra)); !ok) return ok;
    family.capacity = uint32_t(capacity);
    return {};
}

Result<void> GeometryStore::reserveIndices() {
    if (indexRanges_.end() <= indexCapacity_) return {};
    const uint64_t capacity = std::max<uint64_t>(
        {kFirstIndexCapacity, uint64_t(indexCapacity_) * 2, indexRanges_.end()});
    if (auto ok = grow(indices_, "indices", BufferUsage::index, uint64_t(indexCapacity_) * 4,
                       capacity * 4);
        !ok)
        return ok;
    indexCapacity_ = uint32_t(capacity);
    return {};
}

}  // namespace rushlight

#include "renderer/visibility/draw_list.h"

#include "engine/core/hash.h"
#include "renderer/materials/surface_variant.h"
#include "renderer/visibility/radix_sort.h"
#include "shaders/interop/bindings.h"

#include <algorithm>
#include <bit>

namespace rushlight {
namespace {

// Positive floats compare as their bits do.
uint32_t depthBits(float depth) { return std::bit_cast<uint32_t>(std::max(depth, 0.0f)); }

void writeRows(const mat4x3& m, vec4& row0, vec4& row1, vec4& row2) {
    row0 = {m[0].x, m[1].x, m[2].x, m[3].x};
    row1 = {m[0].y, m[1].y, m[2].y, m[3].y};
    row2 = {m[0].z, m[1].z, m[2].z, m[3].z};
}

// Of items that come soon, each after what it is found by: the record, the mesh, which way its
// triangles face.
void prefetch(const FrameWorlds& worlds, const GeometryStore& geometry,
              std::span<const VisibleItem> items, size_t index, bool facing) {
    constexpr size_t kMeshAhead = 8, kFacingAhead = 4;
    worlds.prefetch(items, index);
    if (index + kMeshAhead >= items.size()) return;
    geometry.prefetch(worlds.record(items[index + kMeshAhead].object).mesh);
    if (!facing) return;
    const VisibleItem& item = items[index + kFacingAhead];
    const GpuMesh& mesh = *geometry.find(worlds.record(item.object).mesh);
    if (item.lod >= mesh.groupedLods) return;
    const char* bytes = reinterpret_cast<const char*>(&mesh.facing[item.lod]);
    for (size_t offset = 0; offset < sizeof(FacingGroups); offset += 64)
        __builtin_prefetch(bytes + offset);
}

}  // namespace

// Opaque: by state, then roughly front to back, then equal meshes together.
//
//     63     48 47         38 37          28 27  8 7 5 4        0
//     [ flags ][ texture set ][coarse depth][ mesh ][lod][fine depth]   coarse: exponent and two
//     bits, steps of 25 %
uint64_t opaqueKey(uint32_t flags, uint32_t textureSet, uint32_t mesh, uint32_t lod, float depth) {
    const uint32_t bits = depthBits(depth);
    return uint64_t(flags) << 48 | uint64_t(textureSet & 0x3ff) << 38 |
           uint64_t(bits >> 21 & 0x3ff) << 28 | uint64_t(mesh & 0xfffff) << 8 |
           uint64_t(lod & 7) << 5 | uint64_t(bits >> 16 & 0x1f);
}

// Casters: by state and mesh.
//
//     63     48 47         38 37   23 22   3 2   0   flags: the lowest 16
//     [ flags ][ texture set ][ zero ][ mesh ][lod]
uint64_t shadowKey(uint32_t flags, uint32_t textureSet, uint32_t mesh, uint32_t lod) {
    return uint64_t(flags) << 48 | uint64_t(textureSet & 0x3ff) << 38 |
           uint64_t(mesh & 0xfffff) << 3 | (lod & 7);
}

// Blended: the farthest first, nothing else.
//
//     63        32 31  0
//     [ ~depth    ][zero]
uint64_t blendKey(float depth) { return uint64_t(~depthBits(depth)) << 32; }

uint32_t FrameWorlds::motionFlag(uint32_t object) const {
    if (object >> 31 || !motion) return record(object).surfaceFlags & kMoving;
    return motion->moved(object) ? uint32_t(kMoving) : 0;
}

const mat4x3& FrameWorlds::previousTransform(uint32_t object) const {
    if (object >> 31 || !motion) return world(object).previousTransform(record(object));
    return motion->previous(object);
}

Aabb FrameWorlds::bounds() const {
    Aabb all;
    for (const InstanceWorld* world : worlds)
        if (world)
            if (const Aabb box = world->bounds(); !box.isEmpty()) all.grow(box);
    return all;
}

// Of the groups whose bits are set, one draw a run of them; short gaps are drawn too.
void DrawList::addDraws(const GpuMesh& mesh, uint32_t lod, uint32_t groups, uint32_t instance) {
    constexpr uint32_t kGap = 16 * 3;  // indices that cost less than a draw
    const uint32_t* starts = mesh.facing[lod].firstIndex.data();
    uint32_t runEnd = ~0u;
    for (uint64_t left = groups; left;) {
        const uint32_t begin = uint32_t(std::countr_zero(left));
        const uint32_t end = begin + uint32_t(std::countr_one(left >> begin));
        left &= ~0ull << end;
        if (runEnd != ~0u && starts[begin] - runEnd < kGap) {
            draws_.back().indexCount += starts[end] - runEnd;
        } else {
            draws_.push_back({starts[end] - starts[begin], 1,
                              mesh.lods[lod].firstIndex + starts[begin], int32_t(mesh.firstVertex),
                              instance});
        }
        runEnd = starts[end];
    }
}

void DrawList::addDraw(const GpuMesh& mesh, uint32_t lod, bool asGiven, uint32_t instance) {
    const uint32_t first = asGiven && lod == 0 ? mesh.firstIndex : mesh.lods[lod].firstIndex;
    draws_.push_back({mesh.lods[lod].indexCount, 1, first, int32_t(mesh.firstVertex), instance});
}

void DrawList::arrange(const FrameWorlds& worlds, const GeometryStore& geometry, const Kind& kind) {
    radixSort(items, scratch_);
    batches.clear();
    draws_.clear();
    positions_.resize(items.size());
    stillCount_ = movingCount_ = 0;
    contentHash_ = items.size();
    const bool leavesBacksOut = kind.eye != vec4(0);
    MeshHandle lastMesh;
    uint32_t lastLod = 0, lastGroups = 0, lastDraws = 0, lastTriangles = 0;
    for (size_t i = 0; i < items.size(); ++i) {
        prefetch(worlds, geometry, items, i, leavesBacksOut);
        const VisibleItem& item = items[i];
        const InstanceRecord& r = worlds.record(item.object);
        const GpuMesh& mesh = *geometry.find(r.mesh);
        const bool moving = item.flags & kMoving;
        const uint32_t set = !kind.casters || (item.flags & (kAlphaMask | kTransmission))
                                 ? r.textureSet
                                 : 0;
        DrawBatch* batch = batches.empty() ? nullptr : &batches.back();
        if (!batch || batch->surfaceFlags != item.flags || batch->textureSet != set ||
            batch->extended != mesh.extended) {
            batches.push_back(
                {item.flags, set, mesh.extended, moving, uint32_t(draws_.size()), 0, 0, {}});
            batch = &batches.back();
            lastMesh = {};
        }
        uint32_t& position = moving ? movingCount_ : stillCount_;
        const bool grouped = item.lod < mesh.groupedLods && leavesBacksOut &&
                             !(item.flags & kDoubleSided);
        const uint32_t groups = grouped ? groupsFacing(mesh.facing[item.lod], r.worldFromLocal,
                                                       kind.eye)
                                        : ~0u;
        if (r.mesh == lastMesh && item.lod == lastLod && groups == lastGroups) {
            for (size_t d = draws_.size() - lastDraws; d < draws_.size(); ++d)
                ++draws_[d].instanceCount;
        } else {
            const size_t before = draws_.size();
            if (grouped)
                addDraws(mesh, item.lod, groups, position);
            else
                addDraw(mesh, item.lod, kind.blended, position);
            lastDraws = uint32_t(draws_.size() - before);
            lastTriangles = 0;
            for (size_t d = before; d < draws_.size(); ++d)
                lastTriangles += draws_[d].indexCount / 3;
            batch->drawCount += lastDraws;
        }
        batch->triangleCount += lastTriangles;
        lastMesh = r.mesh;
        lastLod = item.lod;
        lastGroups = groups;
        positions_[i] = position++;
        contentHash_ = mixBits(contentHash_ ^ (uint64_t(item.object) << 32 | r.stamp)) + item.key;
    }
}

void DrawList::allocate(CommandBuffer& buffer) {
    instanceRange = buffer.allocate(stillCount_ * sizeof(InstanceData));
    movingRange = buffer.allocate(movingCount_ * sizeof(MovingInstanceData));
    commandRange = buffer.append(std::span<const DrawIndexedCommand>(draws_));
}

void DrawList::fill(CommandBuffer& buffer, const FrameWorlds& worlds, uint32_t begin,
                    uint32_t end) const {
    std::byte* still = buffer.bytes(instanceRange).data();
    std::byte* moving = buffer.bytes(movingRange).data();
    for (uint32_t i = begin; i < end; ++i) {
        worlds.prefetch(items, i);
        const VisibleItem& item = items[i];
        const InstanceRecord& r = worlds.record(item.object);
        MovingInstanceData data;
        writeRows(r.worldFromLocal, data.now.row0, data.now.row1, data.now.row2);
        data.now.material = r.materialTexel;
        data.now.id = r.id;
        data.now.reserved0 = data.now.reserved1 = 0;
        if (item.flags & kMoving) {
            writeRows(worlds.previousTransform(item.object), data.previousRow0, data.previousRow1,
                      data.previousRow2);
            std::memcpy(moving + positions_[i] * sizeof data, &data, sizeof data);
        } else {
            std::memcpy(still + positions_[i] * sizeof data.now, &data.now, sizeof data.now);
        }
    }
}

void DrawBinder::record(CommandBuffer& commands, const DrawList& list) const {
    if (list.batches.empty()) return;
    commands.push(SetIndexStream{{geometry->indices(), 0, 0, 0}});
    PipelineHandle pipeline;
    uint32_t textureSet = 0;
    int streams = -1;
    for (const DrawBatch& batch : list.batches) {
        if (batch.drawCount == 0) continue;
        if (batch.pipeline != pipeline) commands.push(SetPipeline{batch.pipeline});
        pipeline = batch.pipeline;
        const int wantedStreams = int(batch.extended) + 2 * int(batch.moving);
        if (wantedStreams != streams) {
            const VertexStreams& s = geometry->streams(batch.extended);
            const auto stream = [&](uint32_t slot, uint32_t stride, BufferHandle buffer) {
                commands.push(SetVertexStream{slot, stride, {buffer, 0, 0, 0}});
            };
            stream(RL_STREAM_POSITION, sizeof(VertexPosition), s.positions);
            stream(RL_STREAM_SURFACE, sizeof(VertexSurface), s.surfaces);
            if (batch.extended) stream(RL_STREAM_EXTRA, sizeof(VertexExtra), s.extras);
            commands.push(SetVertexStream{
                RL_STREAM_INSTANCE,
                uint32_t(batch.moving ? sizeof(MovingInstanceData) : sizeof(InstanceData)),
                batch.moving ? list.movingRange : list.instanceRange});
            streams = wantedStreams;
        }
        if (batch.textureSet != textureSet) {
            const TextureSet& set = materials->textureSet(batch.textureSet);
            for (uint32_t slot = 0; slot < kTextureSlots; ++slot)
                if (set[slot].texture)
                    commands.push(
                        BindTexture{kMaterialUnits[slot], set[slot].texture, set[slot].sampler});
            textureSet = batch.textureSet;
        }
        BufferRange range = list.commandRange;
        range.offset += batch.firstDraw * sizeof(DrawIndexedCommand);
        range.size = batch.drawCount * sizeof(DrawIndexedCommand);
        commands.push(MultiDrawIndexed{batch.drawCount, batch.triangleCount, range});
    }
}

}  // namespace rushlight

#include "renderer/frame/draw_list.h"

#include "engine/core/hash.h"
#include "renderer/frame/surface_variant.h"
#include "shaders/interop/bindings.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kInstancesPerJob = 512;

bool isFinite(const mat4x3& m) {
    const vec3 sum = m[0] + m[1] + m[2] + m[3];
    return std::isfinite(sum.x + sum.y + sum.z);
}

ResolvedInstance resolve(const Instance& instance, size_t previousTransformCount,
                         const GeometryStore& geometry, const MaterialStore& materials) {
    ResolvedInstance out;
    const GpuMesh* mesh = geometry.find(instance.mesh);
    const GpuMaterial* material = materials.find(instance.material);
    if (!mesh || !material || !isFinite(instance.worldFromLocal)) return out;
    const bool moving = instance.flags & kInstanceMoving;
    if (moving && instance.previousTransform >= previousTransformCount) return out;

    const Aabb box = transformAabb(instance.worldFromLocal, mesh->bounds);
    out.center = box.center();
    out.halfExtent = box.halfExtent();
    out.mesh = mesh;
    out.textureSet = material->textureSet;
    out.materialTexel = material->texel;
    out.surfaceFlags = material->surfaceFlags;
    if (mesh->extended) out.surfaceFlags |= kExtended;
    else out.surfaceFlags &= ~uint32_t(kSecondUv);
    if (!mesh->hasTangents) out.surfaceFlags &= ~uint32_t(kNormalTexture);
    if (glm::determinant(mat3(instance.worldFromLocal)) < 0) out.surfaceFlags |= kMirrored;
    if (moving) out.surfaceFlags |= kMoving;
    return out;
}

// Positive floats compare as their bits do.
uint32_t depthBits(float depth) { return std::bit_cast<uint32_t>(std::max(depth, 0.0f)); }

// Opaque and shadow:
//
//     63     48 47        38 37          28 27  8 7        0
//     [ flags ][texture set ][coarse depth][ mesh ][fine depth]    coarse: exponent and two bits, steps of 25 %
uint64_t opaqueKey(uint32_t flags, uint32_t textureSet, uint32_t mesh, float depth) {
    const uint32_t bits = depthBits(depth);
    return uint64_t(flags) << 48 | uint64_t(textureSet & 0x3ff) << 38 |
           uint64_t(bits >> 21 & 0x3ff) << 28 | uint64_t(mesh & 0xfffff) << 8 |
           uint64_t(bits >> 13 & 0xff);
}

// Blended: the farthest first, nothing else.
uint64_t blendKey(float depth) { return uint64_t(~depthBits(depth)) << 32; }

// A caster's shader depends on its material only where alpha cuts it. A closed mesh casts the same shadow with its
// back faces culled; kDoubleSided stands for "do not cull".
uint32_t shadowFlags(const ResolvedInstance& resolved) {
    const uint32_t flags = resolved.surfaceFlags;
    if (flags & kAlphaMask)
        return kAlphaMask | kDoubleSided |
               (flags & (kBaseColorTexture | kSecondUv | kUvTransforms | kExtended));
    if (!resolved.mesh->closed || (flags & kDoubleSided)) return kDoubleSided;
    return flags & kMirrored;
}

void writeRows(const mat4x3& m, vec4& row0, vec4& row1, vec4& row2) {
    row0 = {m[0].x, m[1].x, m[2].x, m[3].x};
    row1 = {m[0].y, m[1].y, m[2].y, m[3].y};
    row2 = {m[0].z, m[1].z, m[2].z, m[3].z};
}

}  // namespace

void resolveInstances(std::span<const Instance> instances, size_t previousTransformCount,
                      const GeometryStore& geometry, const MaterialStore& materials,
                      JobSystem& jobs, std::vector<ResolvedInstance>& out) {
    out.resize(instances.size());
    jobs.forRanges(uint32_t(instances.size()), kInstancesPerJob,
                   [&](uint32_t begin, uint32_t end) {
                       for (uint32_t i = begin; i < end; ++i)
                           out[i] = resolve(instances[i], previousTransformCount, geometry,
                                            materials);
                   });
}

void DrawList::begin(DrawListKind kind) {
    kind_ = kind;
    items_.clear();
}

bool DrawList::belongs(uint32_t instanceFlags, uint32_t surfaceFlags) const {
    constexpr uint32_t kMovingEmission = kMoving | kEmissive;
    switch (kind_) {
        case DrawListKind::opaque: return !(surfaceFlags & kBlend);
        case DrawListKind::blend: return surfaceFlags & kBlend;
        case DrawListKind::shadow:
            return !(surfaceFlags & kBlend) && (instanceFlags & kInstanceCastsShadow);
        case DrawListKind::movingEmission:
            return !(surfaceFlags & kBlend) && (surfaceFlags & kMovingEmission) == kMovingEmission;
    }
    return false;
}

void DrawList::add(uint32_t index, const Instance& instance, const ResolvedInstance& resolved,
                   const vec3& eye, const vec3& forward) {
    const float depth = glm::dot(resolved.center - eye, forward);
    const uint32_t mesh = instance.mesh.index();
    Item item{0, index, resolved.surfaceFlags};
    switch (kind_) {
        case DrawListKind::opaque:
        case DrawListKind::movingEmission:
            item.key = opaqueKey(resolved.surfaceFlags, resolved.textureSet, mesh, depth);
            break;
        case DrawListKind::blend: item.key = blendKey(depth); break;
        case DrawListKind::shadow:
            item.flags = shadowFlags(resolved);
            item.key = opaqueKey(item.flags, item.flags & kAlphaMask ? resolved.textureSet : 0,
                                 mesh, 0);
            break;
    }
    items_.push_back(item);
}

void DrawList::end(std::span<const ResolvedInstance> resolved) {
    std::sort(items_.begin(), items_.end(), [](const Item& a, const Item& b) {
        return a.key != b.key ? a.key < b.key : a.instance < b.instance;
    });
    formBatches(resolved);
}

void DrawList::formBatches(std::span<const ResolvedInstance> resolved) {
    batches.clear();
    draws_.clear();
    stillCount_ = movingCount_ = 0;
    const bool shadow = kind_ == DrawListKind::shadow;
    const GpuMesh* lastMesh = nullptr;
    for (const Item& item : items_) {
        const ResolvedInstance& r = resolved[item.instance];
        const bool moving = item.flags & kMoving;
        const uint32_t set = !shadow || (item.flags & kAlphaMask) ? r.textureSet : 0;
        const bool extended = r.mesh->extended;
        DrawBatch* batch = batches.empty() ? nullptr : &batches.back();
        if (!batch || batch->surfaceFlags != item.flags || batch->textureSet != set ||
            batch->extended != extended) {
            batches.push_back(
                {item.flags, set, extended, moving, uint32_t(draws_.size()), 0, 0, {}});
            batch = &batches.back();
            lastMesh = nullptr;
        }
        uint32_t& position = moving ? movingCount_ : stillCount_;
        batch->triangleCount += r.mesh->indexCount / 3;
        if (r.mesh == lastMesh) {
            ++draws_.back().instanceCount;
        } else {
            draws_.push_back({r.mesh->indexCount, 1, r.mesh->firstIndex,
                              int32_t(r.mesh->firstVertex), position});
            ++batch->drawCount;
        }
        lastMesh = r.mesh;
        ++position;
    }
}

void DrawList::allocate(CommandBuffer& buffer) {
    instanceRange = buffer.allocate(stillCount_ * sizeof(InstanceData));
    movingRange = buffer.allocate(movingCount_ * sizeof(MovingInstanceData));
    commandRange = buffer.allocate(draws_.size() * sizeof(DrawIndexedCommand));
}

void DrawList::fill(CommandBuffer& buffer, std::span<const Instance> instances,
                    std::span<const ResolvedInstance> resolved,
                    std::span<const mat4x3> previousTransforms) {
    std::byte* still = buffer.bytes(instanceRange).data();
    std::byte* moving = buffer.bytes(movingRange).data();
    for (const Item& item : items_) {
        const Instance& instance = instances[item.instance];
        MovingInstanceData data;
        writeRows(instance.worldFromLocal, data.now.row0, data.now.row1, data.now.row2);
        data.now.material = resolved[item.instance].materialTexel;
        data.now.id = instance.id;
        data.now.reserved0 = data.now.reserved1 = 0;
        if (item.flags & kMoving) {
            writeRows(previousTransforms[instance.previousTransform], data.previousRow0,
                      data.previousRow1, data.previousRow2);
            std::memcpy(moving, &data, sizeof data);
            moving += sizeof data;
        } else {
            std::memcpy(still, &data.now, sizeof data.now);
            still += sizeof data.now;
        }
    }
    if (!draws_.empty())
        std::memcpy(buffer.bytes(commandRange).data(), draws_.data(),
                    draws_.size() * sizeof(DrawIndexedCommand));
}

uint64_t DrawList::contentHash(const CommandBuffer& buffer) const {
    const auto hash = [&](const BufferRange& range, uint64_t seed) {
        return hashBytes(buffer.data().data() + range.offset, range.size, seed);
    };
    uint64_t h = hash(instanceRange, 1);
    h = hash(commandRange, h);
    for (const DrawBatch& batch : batches)
        h = mixBits(h ^ (uint64_t(batch.surfaceFlags) << 32 | batch.textureSet));
    return h;
}

void DrawBinder::record(CommandBuffer& commands, const DrawList& list) const {
    if (list.batches.empty()) return;
    commands.push(SetIndexStream{{geometry->indices(), 0, 0, 0}});
    PipelineHandle pipeline;
    uint32_t textureSet = 0;
    int streams = -1;
    for (const DrawBatch& batch : list.batches) {
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
                    commands.push(BindTexture{slot, set[slot].texture, set[slot].sampler});
            textureSet = batch.textureSet;
        }
        BufferRange range = list.commandRange;
        range.offset += batch.firstDraw * sizeof(DrawIndexedCommand);
        range.size = batch.drawCount * sizeof(DrawIndexedCommand);
        commands.push(MultiDrawIndexed{batch.drawCount, batch.triangleCount, range});
    }
}

}  // namespace rushlight

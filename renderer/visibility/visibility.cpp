#include "renderer/visibility/visibility.h"

#include "renderer/visibility/caster.h"

#include <bit>

namespace rushlight {
namespace {

constexpr uint32_t kBlocksPerChunk = 8;

bool emitsWhileMoving(const VisibleItem& item) {
    constexpr uint32_t kBoth = kMoving | kEmissive;
    return (item.flags & kBoth) == kBoth;
}

}  // namespace

DetailScale cameraDetail(const CameraMatrices& camera, uint32_t targetHeight) {
    DetailScale scale;
    scale.eye = camera.position;
    scale.perspective = camera.perspective;
    scale.nearest = camera.nearPlane;
    scale.pixelsPerMetre = float(targetHeight) /
                           (2 * (camera.perspective ? camera.tanHalfY : camera.halfHeight));
    return scale;
}

void Visibility::makeVolumes(const Inputs& in) {
    const FrameSettings& settings = *in.settings;
    const uint32_t cascadeCount = in.cascades->count;
    volumes_.assign(1 + cascadeCount, {});
    cameraScale_ = cameraDetail(*in.camera, in.targetHeight);
    cameraScale_.maxError = settings.lodPixelError;
    cameraScale_.minSize = settings.smallObjectPixels;
    for (uint32_t i = 0; i < cascadeCount; ++i) {
        DetailScale& scale = cascadeScales_[i];
        scale = {};
        scale.pixelsPerMetre = 1 / in.cascades->cascades[i].metresPerTexel;
        scale.maxError = settings.shadowLodTexelError;
        scale.minSize = settings.smallObjectPixels;
    }
    if (!settings.frustumCulling) return;
    volumes_[0].add(in.camera->frustum);
    for (uint32_t i = 0; i < cascadeCount; ++i)
        in.cascades->addVolume(i, in.camera->frustum, volumes_[1 + i]);
}

void Visibility::findBlocks(const Inputs& in) {
    blocks_.clear();
    for (uint8_t world = 0; world < in.worlds.worlds.size(); ++world) {
        if (!in.worlds.worlds[world]) continue;
        const auto indices = in.worlds.worlds[world]->indices();
        for (uint8_t index = 0; index < indices.size(); ++index) {
            visits_.clear();
            indices[index].visit(volumes_, visits_);
            for (const SpatialIndex::Visit& visit : visits_)
                blocks_.push_back({visit, world, index});
        }
    }
}

void Visibility::addToCamera(const Inputs& in, uint32_t object, const InstanceRecord& r,
                             Chunk& chunk) const {
    const vec3 center = r.center();
    const float pixels = cameraScale_.at(center, r.radius);
    if (2 * r.radius * pixels < cameraScale_.minSize) {
        ++chunk.culledSmall;
        return;
    }
    const GpuMesh& mesh = *in.geometry->find(r.mesh);
    const float error = cameraScale_.maxError / (pixels * r.scale);
    const uint32_t last = in.lods->last(object, r.stamp);
    const uint32_t lod = in.settings->cut ? pickLod(mesh, error)
                                          : pickLodSteadily(mesh, error, last);
    if (lod != last) chunk.lods.push_back({object, r.stamp, lod});
    const float depth = glm::dot(center - in.camera->position, in.camera->forward);
    const bool blended = r.surfaceFlags & kBlend;
    VisibleItem item;
    item.object = object;
    const uint32_t flags = r.surfaceFlags | in.worlds.motionFlag(object);
    item.flags = flags & kSurfaceFlags;
    item.lod = lod;
    item.key = blended ? blendKey(depth)
                       : opaqueKey(flags, r.textureSet, r.mesh.index(), lod, depth);
    chunk.items[blended ? kBlended : kOpaque].push_back(item);
}

void Visibility::addToCascade(const Inputs& in, uint32_t cascade, uint32_t object,
                              const InstanceRecord& r, Chunk& chunk) const {
    const bool glass = coloursLight(r.surfaceFlags);
    if (!glass && !castsShadow(r.surfaceFlags)) return;
    const DetailScale& scale = cascadeScales_[cascade];
    if (2 * r.radius * scale.pixelsPerMetre < scale.minSize) return;
    if (in.settings->frustumCulling &&
        in.cascades->isFinerElsewhere(cascade, r.center(), r.box.halfExtent()))
        return;
    const GpuMesh& mesh = *in.geometry->find(r.mesh);
    const VisibleItem item = makeCaster(object, r, mesh, scale.maxError, scale.pixelsPerMetre);
    chunk.items[(glass ? kFirstGlass : kFirstCaster) + cascade].push_back(item);
}

void Visibility::testBlock(const Inputs& in, const BlockVisit& at, Chunk& chunk) const {
    InstanceWorld& world = *in.worlds.worlds[at.world];
    const SpatialIndex& index = world.indices()[at.index];
    const uint32_t block = at.visit.block;
    for (uint32_t views = at.visit.touching; views; views &= views - 1) {
        const uint32_t view = uint32_t(std::countr_zero(views));
        uint64_t seen = index.live(block);
        if (!(at.visit.inside >> view & 1))
            seen &= touchingBoxes(index.boxes(block), volumes_[view]);
        for (uint64_t soon = seen; soon; soon &= soon - 1)
            world.prefetch(index.slotAt(block * kBlockSize + uint32_t(std::countr_zero(soon))));
        for (; seen; seen &= seen - 1) {
            const uint32_t slot = index.slotAt(block * kBlockSize +
                                               uint32_t(std::countr_zero(seen)));
            const uint32_t object = FrameWorlds::object(at.world, slot);
            if (view == 0)
                addToCamera(in, object, world.record(slot), chunk);
            else
                addToCascade(in, view - 1, object, world.record(slot), chunk);
        }
    }
}

DrawList& Visibility::listOf(Lists& lists, uint32_t index) {
    if (index >= kFirstGlass) return lists.glass[index - kFirstGlass];
    if (index >= kFirstCaster) return lists.casters[index - kFirstCaster];
    return index == kOpaque ? lists.opaque : lists.blended;
}

// In the order of chunks.
void Visibility::collect(uint32_t list, std::vector<VisibleItem>& items) const {
    items.clear();
    for (uint32_t i = 0; i < chunkCount_; ++i)
        items.insert(items.end(), chunks_[i].items[list].begin(), chunks_[i].items[list].end());
}

Visibility::Counts Visibility::gather(const Inputs& in, JobSystem& jobs, Lists& lists) {
    makeVolumes(in);
    findBlocks(in);
    const uint32_t blockCount = uint32_t(blocks_.size());
    chunkCount_ = (blockCount + kBlocksPerChunk - 1) / kBlocksPerChunk;
    if (chunks_.size() < chunkCount_) chunks_.resize(chunkCount_);
    jobs.forRanges(blockCount, kBlocksPerChunk, [&](uint32_t begin, uint32_t end) {
        Chunk& chunk = chunks_[begin / kBlocksPerChunk];
        for (auto& items : chunk.items) items.clear();
        chunk.lods.clear();
        chunk.culledSmall = 0;
        for (uint32_t b = begin; b < end; ++b) testBlock(in, blocks_[b], chunk);
    });

    Counts counts;
    collect(kOpaque, lists.opaque.items);
    collect(kBlended, lists.blended.items);
    if (in.settings->occlusionCulling)
        counts.culledOcclusion = occlusion_.cull(
            {in.worlds, in.geometry, in.camera, cameraScale_, in.targetWidth, in.targetHeight},
            jobs, lists.opaque.items, lists.blended.items);

    const FacingEye eye = in.camera->perspective ? vec4(in.camera->position, 1)
                                                 : vec4(-in.camera->forward, 0);
    const uint32_t cascades = in.cascades->count;
    jobs.forRanges(kFirstCaster + 2 * cascades, 1, [&](uint32_t begin, uint32_t end) {
        for (uint32_t job = begin; job < end; ++job) {
            const uint32_t i = job < kFirstCaster + cascades
                                   ? job
                                   : job - cascades + kFirstGlass - kFirstCaster;
            DrawList& list = listOf(lists, i);
            if (i >= kFirstCaster) collect(i, list.items);
            const DrawList::Kind kind{i >= kFirstCaster, i == kBlended,
                                      i == kOpaque ? eye : vec4(0)};
            list.arrange(in.worlds, *in.geometry, kind);
            if (i != kOpaque) continue;
            DrawList& emission = lists.movingEmission;
            emission.items.clear();
            for (const VisibleItem& item : list.items)
                if (emitsWhileMoving(item)) emission.items.push_back(item);
            emission.arrange(in.worlds, *in.geometry, kind);
        }
    });
    counts.visible = uint32_t(lists.opaque.items.size() + lists.blended.items.size());
    for (uint32_t i = 0; i < chunkCount_; ++i) {
        counts.culledSmall += chunks_[i].culledSmall;
        in.lods->stage(chunks_[i].lods);
    }
    return counts;
}

}  // namespace rushlight

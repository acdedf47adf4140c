#include "renderer/shadows/shadow_visibility.h"

#include "engine/core/hash.h"
#include "renderer/visibility/caster.h"

#include <algorithm>
#include <bit>

namespace rushlight {
namespace {

constexpr uint32_t kBlocksPerChunk = 8;

// Its box, as seen from the light, is not all beyond the light's range.
bool isWithin(const ShadowView& view, const Aabb& box) {
    const vec3 nearest = glm::clamp(view.scale.eye, box.low, box.high) - view.scale.eye;
    return glm::dot(nearest, nearest) < view.range * view.range;
}

}  // namespace

void ShadowVisibility::findBlocks(const Inputs& in) {
    blocks_.clear();
    volumes_.clear();
    for (const ShadowView* view : in.views) volumes_.push_back(view->volume);
    const std::span<const CullVolume> volumes(volumes_);
    for (uint8_t world = 0; world < in.worlds.worlds.size(); ++world) {
        if (!in.worlds.worlds[world]) continue;
        const auto indices = in.worlds.worlds[world]->indices();
        for (uint8_t index = 0; index < indices.size(); ++index) {
            if (!(in.indices >> index & 1)) continue;
            for (uint32_t first = 0; first < volumes.size(); first += SpatialIndex::kMaxViews) {
                visits_.clear();
                const size_t count = std::min<size_t>(SpatialIndex::kMaxViews,
                                                      volumes.size() - first);
                indices[index].visit(volumes.subspan(first, count), visits_);
                for (const SpatialIndex::Visit& visit : visits_)
                    blocks_.push_back({visit, first, world, index});
            }
        }
    }
}

void ShadowVisibility::testBlock(const Inputs& in, const BlockVisit& at,
                                 std::vector<Cast>& casts) const {
    const InstanceWorld& world = *in.worlds.worlds[at.world];
    const SpatialIndex& index = world.indices()[at.index];
    const uint32_t block = at.visit.block;
    for (uint32_t views = at.visit.touching; views; views &= views - 1) {
        const uint32_t bit = uint32_t(std::countr_zero(views)), v = at.firstView + bit;
        const ShadowView& view = *in.views[v];
        uint64_t seen = index.live(block);
        if (!(at.visit.inside >> bit & 1)) seen &= touchingBoxes(index.boxes(block), volumes_[v]);
        for (; seen; seen &= seen - 1) {
            const uint32_t slot = index.slotAt(block * kBlockSize +
                                               uint32_t(std::countr_zero(seen)));
            const InstanceRecord& r = world.record(slot);
            const bool glass = coloursLight(r.surfaceFlags);
            if ((!glass && !castsShadow(r.surfaceFlags)) || !isWithin(view, r.box)) continue;
            const float texels = view.scale.at(r.center(), r.radius);
            if (2 * r.radius * texels < view.scale.minSize) continue;
            const GpuMesh& mesh = *in.geometry->find(r.mesh);
            casts.push_back({makeCaster(FrameWorlds::object(at.world, slot), r, mesh,
                                        view.scale.maxError, texels),
                             glass ? v + uint32_t(in.views.size()) : v, r.stamp});
        }
    }
}

// Sums do not depend on the order of blocks, which may change when an index is built again.
void ShadowVisibility::sortByView(uint32_t viewCount) {
    ranges_.assign(2 * viewCount, {});
    const auto each = [&](auto&& f) {
        for (uint32_t i = 0; i < chunkCount_; ++i)
            for (const Cast& cast : chunks_[i]) f(cast);
    };
    each([&](const Cast& cast) { ++ranges_[cast.range].count; });
    uint32_t total = 0;
    for (Range& range : ranges_) {
        range.first = total;
        total += std::exchange(range.count, 0);
    }
    items_.resize(total);
    each([&](const Cast& cast) {
        Range& range = ranges_[cast.range];
        items_[range.first + range.count++] = cast.item;
        range.hash += mixBits(mixBits(uint64_t(cast.item.object) << 32 | cast.stamp) ^
                              cast.item.key);
    });
}

void ShadowVisibility::gather(const Inputs& in, JobSystem& jobs) {
    findBlocks(in);
    const uint32_t blockCount = uint32_t(blocks_.size());
    chunkCount_ = (blockCount + kBlocksPerChunk - 1) / kBlocksPerChunk;
    if (chunks_.size() < chunkCount_) chunks_.resize(chunkCount_);
    jobs.forRanges(blockCount, kBlocksPerChunk, [&](uint32_t begin, uint32_t end) {
        std::vector<Cast>& casts = chunks_[begin / kBlocksPerChunk];
        casts.clear();
        for (uint32_t b = begin; b < end; ++b) testBlock(in, blocks_[b], casts);
    });
    sortByView(uint32_t(in.views.size()));
}

ShadowVisibility::Found ShadowVisibility::foundIn(uint32_t index) const {
    const Range& range = ranges_[index];
    return {range.hash, std::span(items_).subspan(range.first, range.count)};
}

}  // namespace rushlight

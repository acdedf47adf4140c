#include "renderer/visibility/spatial_index.h"

#include "renderer/visibility/radix_sort.h"

#include <atomic>
#include <bit>
#include <cmath>

namespace rushlight {
namespace {

uint32_t blocksFor(uint32_t count) { return (count + kBlockSize - 1) / kBlockSize; }

// Two zeros between each of the lower ten bits.
uint32_t spread(uint32_t x) {
    x &= 0x3ff;
    x = (x | x << 16) & 0x030000ff;
    x = (x | x << 8) & 0x0300f00f;
    x = (x | x << 4) & 0x030c30c3;
    return (x | x << 2) & 0x09249249;
}

// Large objects apart from small ones, so that they do not blow up the boxes of small neighbours.
//
//     33   31 30                             0
//     [ size ][ Morton code of the centre    ]
uint64_t curveKey(const Aabb& box, const Aabb& all) {
    const vec3 extent = glm::max(all.high - all.low, vec3(1e-20f));
    const vec3 at = glm::clamp((box.center() - all.low) / extent, 0.0f, 1.0f) * 1023.0f;
    const vec3 relative = (box.high - box.low) / extent;
    const float size = std::max({relative.x, relative.y, relative.z});
    const uint32_t sizeClass = size > 0.25f ? 0 : size > 0.06f ? 1 : 2;
    return uint64_t(sizeClass) << 31 | spread(uint32_t(at.x)) | spread(uint32_t(at.y)) << 1 |
           spread(uint32_t(at.z)) << 2;
}

double halfArea(const Aabb& box) {
    if (box.isEmpty()) return 0;
    const glm::dvec3 side(box.high - box.low);
    return side.x * side.y + side.y * side.z + side.z * side.x;
}

Aabb boundsOf(const BoxBlock& boxes, uint64_t live) {
    Aabb all;
    for (; live; live &= live - 1) all.grow(boxes.get(uint32_t(std::countr_zero(live))));
    return all;
}

}  // namespace

void SpatialIndex::clear() {
    for (Level& level : levels_) {
        level.boxes.clear();
        level.live.clear();
        level.dirty.clear();
    }
    levels_.resize(1);
    slots_.clear();
    size_ = end_ = 0;
    cost_ = builtCost_ = 0;
}

// Room for object blocks, and for the nodes above them up to a single root.
void SpatialIndex::reserveBlocks(uint32_t blocks) {
    for (uint32_t level = 0;; ++level) {
        if (levels_.size() <= level) {
            levels_.emplace_back();
            // what is below was a root: the new root has to take its box in
            for (uint8_t& dirty : levels_[level - 1].dirty) dirty = 1;
        }
        Level& l = levels_[level];
        if (l.boxes.size() < blocks) {
            l.boxes.resize(blocks);
            l.live.resize(blocks, 0);
            l.dirty.resize(blocks, 1);
        }
        if (blocks <= 1) return;
        blocks = blocksFor(blocks);
    }
}

void SpatialIndex::build(std::span<const Object> objects) {
    clear();
    Aabb all;
    for (const Object& object : objects) all.grow(object.box);
    order_.resize(objects.size());
    for (uint32_t i = 0; i < objects.size(); ++i) order_[i] = {curveKey(objects[i].box, all), i};
    radixSort(order_, scratch_);

    size_ = end_ = uint32_t(objects.size());
    reserveBlocks(blocksFor(size_));
    slots_.resize(blocksFor(size_) * kBlockSize);
    Level& level = levels_[0];
    for (uint32_t position = 0; position < size_; ++position) {
        const Object& object = objects[order_[position].object];
        const uint32_t block = position / kBlockSize, lane = position % kBlockSize;
        level.boxes[block].set(lane, object.box);
        level.live[block] |= uint64_t(1) << lane;
        slots_[position] = object.slot;
    }
    refit();
    builtCost_ = cost_;
}

uint32_t SpatialIndex::append(const Object& object) {
    const uint32_t position = end_++;
    const uint32_t block = position / kBlockSize;
    reserveBlocks(block + 1);
    slots_.resize(size_t(block + 1) * kBlockSize);
    Level& level = levels_[0];
    level.boxes[block].set(position % kBlockSize, object.box);
    level.live[block] |= uint64_t(1) << position % kBlockSize;
    level.dirty[block] = 1;
    slots_[position] = object.slot;
    ++size_;
    return position;
}

void SpatialIndex::remove(uint32_t position) {
    Level& level = levels_[0];
    level.live[position / kBlockSize] &= ~(uint64_t(1) << position % kBlockSize);
    level.dirty[position / kBlockSize] = 1;
    --size_;
}

void SpatialIndex::setBox(uint32_t position, const Aabb& box) {
    Level& level = levels_[0];
    level.boxes[position / kBlockSize].set(position % kBlockSize, box);
    std::atomic_ref(level.dirty[position / kBlockSize]).store(1, std::memory_order_relaxed);
}

// The block's own box, into its parent.
void SpatialIndex::refitBlock(uint32_t levelIndex, uint32_t block) {
    Level& level = levels_[levelIndex];
    level.dirty[block] = 0;
    const Aabb box = boundsOf(level.boxes[block], level.live[block]);
    const bool isRoot = levelIndex + 1 == levels_.size();
    if (isRoot) {
        if (levelIndex == 0) cost_ = halfArea(box);
        return;
    }
    Level& above = levels_[levelIndex + 1];
    const uint32_t parent = block / kBlockSize, lane = block % kBlockSize;
    const uint64_t bit = uint64_t(1) << lane;
    if (levelIndex == 0) {
        if (above.live[parent] & bit) cost_ -= halfArea(above.boxes[parent].get(lane));
        cost_ += halfArea(box);
    }
    if (box.isEmpty()) {
        above.live[parent] &= ~bit;
    } else {
        above.boxes[parent].set(lane, box);
        above.live[parent] |= bit;
    }
    above.dirty[parent] = 1;
}

void SpatialIndex::refit() {
    for (uint32_t level = 0; level < levels_.size(); ++level)
        for (uint32_t block = 0; block < levels_[level].boxes.size(); ++block)
            if (levels_[level].dirty[block]) refitBlock(level, block);
}

Aabb SpatialIndex::bounds() const {
    const Level& root = levels_.back();
    return root.boxes.empty() ? Aabb{} : boundsOf(root.boxes[0], root.live[0]);
}

void SpatialIndex::visit(std::span<const CullVolume> volumes, std::vector<Visit>& out) const {
    RL_CHECK(volumes.size() <= kMaxViews, "at most 32 views can be tested at once");
    if (size_ == 0 || volumes.empty()) return;
    const uint32_t every = uint32_t((uint64_t(1) << volumes.size()) - 1);
    if (levels_.size() == 1)
        out.push_back({0, every, 0});
    else
        visitNode(uint32_t(levels_.size() - 1), 0, every, 0, volumes, out);
}

void SpatialIndex::visitNode(uint32_t level, uint32_t block, uint32_t touching, uint32_t inside,
                             std::span<const CullVolume> volumes, std::vector<Visit>& out) const {
    const Level& l = levels_[level];
    std::array<BlockMasks, kMaxViews> masks;
    uint64_t any = 0;
    for (uint32_t views = touching; views; views &= views - 1) {
        const uint32_t v = uint32_t(std::countr_zero(views));
        if (inside >> v & 1)
            masks[v] = {l.live[block], l.live[block]};
        else
            masks[v] = testBoxes(l.boxes[block], volumes[v]);
        any |= masks[v].touching;
    }
    for (any &= l.live[block]; any; any &= any - 1) {
        const uint32_t lane = uint32_t(std::countr_zero(any));
        uint32_t childTouching = 0, childInside = 0;
        for (uint32_t views = touching; views; views &= views - 1) {
            const uint32_t v = uint32_t(std::countr_zero(views));
            childTouching |= uint32_t(masks[v].touching >> lane & 1) << v;
            childInside |= uint32_t(masks[v].inside >> lane & 1) << v;
        }
        const uint32_t child = block * kBlockSize + lane;
        if (level == 1)
            out.push_back({child, childTouching, childInside});
        else
            visitNode(level - 1, child, childTouching, childInside, volumes, out);
    }
}

uint64_t SpatialIndex::bytes() const {
    uint64_t sum = slots_.capacity() * sizeof(uint32_t) +
                   (order_.capacity() + scratch_.capacity()) * sizeof(Sortable);
    for (const Level& level : levels_)
        sum += level.boxes.capacity() * sizeof(BoxBlock) + level.live.capacity() * 9;
    return sum;
}

}  // namespace rushlight

#pragma once
// A bounding-volume hierarchy of objects with 64 children a node, each node's boxes by component,
// so that one node is one SIMD test. Objects are kept in blocks of 64 along a Morton curve; a
// node's box is exact. Not thread-safe, apart from what says so.

#include "renderer/geometry/box_block.h"

#include <span>
#include <vector>

namespace rushlight {

class SpatialIndex {
public:
    static constexpr uint32_t kMaxViews = 32;

    struct Object {
        uint32_t slot = 0;  ///< the owner's name for it
        Aabb box;           ///< finite
    };

    /// A block of objects that views may see. Bit v of `touching`: its box touches view v's volume;
    /// of `inside`: it is wholly inside, so that none of its objects needs a test.
    struct Visit {
        uint32_t block;
        uint32_t touching;
        uint32_t inside;
    };

    /// Forgets all and takes these, in an order of its own; see slotAt.
    void build(std::span<const Object> objects);
    /// Adds one, wherever there is room; returns its position. Many of them make the hierarchy
    /// worse: see isWorn.
    uint32_t append(const Object& object);
    void remove(uint32_t position);
    /// Takes effect with refit(). Different positions may be set from different threads at the same
    /// time.
    void setBox(uint32_t position, const Aabb& box);
    /// Brings the hierarchy up to date with what was set, added and removed; costs what changed.
    void refit();
    /// Changes have made the boxes so much larger than build() would that building again pays.
    bool isWorn() const { return cost_ > 2 * builtCost_ && size() > 2 * kBlockSize; }

    /// Finds the blocks that any of the volumes touches, in the order of blocks. After refit().
    void visit(std::span<const CullVolume> volumes, std::vector<Visit>& out) const;

    uint32_t size() const { return size_; }          ///< objects
    uint32_t positionCount() const { return end_; }  ///< positions in use or once in use
    Aabb bounds() const;                             ///< of all objects; after refit()

    const BoxBlock& boxes(uint32_t block) const { return levels_[0].boxes[block]; }
    uint64_t live(uint32_t block) const { return levels_[0].live[block]; }
    uint32_t slotAt(uint32_t position) const { return slots_[position]; }
    bool isLive(uint32_t position) const {
        return levels_[0].live[position / kBlockSize] >> position % kBlockSize & 1;
    }
    Aabb boxAt(uint32_t position) const {
        return levels_[0].boxes[position / kBlockSize].get(position % kBlockSize);
    }
    uint64_t bytes() const;  ///< memory held

private:
    struct Level {
        std::vector<BoxBlock> boxes;
        std::vector<uint64_t> live;
        std::vector<uint8_t> dirty;
    };
    struct Sortable {
        uint64_t key;
        uint32_t object;
    };
    void clear();
    void reserveBlocks(uint32_t blocks);
    void refitBlock(uint32_t level, uint32_t block);
    void visitNode(uint32_t level, uint32_t block, uint32_t touching, uint32_t inside,
                   std::span<const CullVolume> volumes, std::vector<Visit>& out) const;

    std::vector<Level> levels_{1};  ///< 0 holds objects; the last has one block
    std::vector<uint32_t> slots_;   ///< by position
    std::vector<Sortable> order_, scratch_;
    uint32_t size_ = 0;
    uint32_t end_ = 0;
    double cost_ = 0, builtCost_ = 0;  ///< sums over the object blocks' half surface areas
};

}  // namespace rushlight

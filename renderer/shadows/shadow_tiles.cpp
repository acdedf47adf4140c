#include "renderer/shadows/shadow_tiles.h"

#include "engine/core/check.h"

#include <algorithm>
#include <bit>

namespace rushlight {
namespace {

// Every other bit, from bit 0.
uint32_t compact(uint32_t x) {
    x &= 0x55555555;
    x = (x | x >> 1) & 0x33333333;
    x = (x | x >> 2) & 0x0f0f0f0f;
    return (x | x >> 4) & 0x00ff00ff;
}

uint32_t spread(uint32_t x) {
    x = (x | x << 4) & 0x0f0f0f0f;
    x = (x | x << 2) & 0x33333333;
    return (x | x << 1) & 0x55555555;
}

}  // namespace

void ShadowTiles::reset(uint32_t size, uint32_t smallest) {
    RL_CHECK(std::has_single_bit(size) && std::has_single_bit(smallest) && size <= 16384 &&
                 smallest <= size && size / smallest < 1u << kLevels,
             "an atlas and its smallest tile are powers of two");
    size_ = size;
    smallest_ = smallest;
    freeTexels_ = uint64_t(size) * size;
    for (uint32_t level = 0; level < kLevels; ++level) {
        free_[level].clear();
        // All that a level can ever hold: three of four, or it would have been merged. Small levels
        // in full.
        if (smallest <= size >> level) free_[level].reserve(size_t(1) << std::min(2 * level, 12u));
    }
    free_[0].push_back(0);
}

uint32_t ShadowTiles::levelOf(uint32_t size) const {
    RL_CHECK(std::has_single_bit(size) && size >= smallest_ && size <= size_,
             "a tile's size is a power of two within the atlas");
    return uint32_t(std::countr_zero(size_) - std::countr_zero(size));
}

std::optional<ShadowTile> ShadowTiles::allocate(uint32_t size) {
    const uint32_t wanted = levelOf(size);
    uint32_t level = wanted;
    while (free_[level].empty()) {
        if (level == 0) return {};
        --level;
    }
    uint32_t code = free_[level].front();
    free_[level].erase(free_[level].begin());
    while (level < wanted) {
        ++level;
        code *= 4;
        for (uint32_t buddy = 1; buddy < 4; ++buddy) insert(level, code + buddy);
    }
    freeTexels_ -= uint64_t(size) * size;
    return ShadowTile{uint16_t(compact(code) * size), uint16_t(compact(code >> 1) * size),
                      uint16_t(size)};
}

void ShadowTiles::insert(uint32_t level, uint32_t code) {
    auto& codes = free_[level];
    codes.insert(std::ranges::lower_bound(codes, code), code);
}

void ShadowTiles::release(const ShadowTile& tile) {
    uint32_t level = levelOf(tile.size);
    uint32_t code = spread(tile.x / tile.size) | spread(tile.y / tile.size) << 1;
    freeTexels_ += uint64_t(tile.size) * tile.size;
    insert(level, code);
    for (; level > 0; --level, code /= 4) {
        auto& codes = free_[level];
        const auto first = std::ranges::lower_bound(codes, code & ~3u);
        if (codes.end() - first < 4 || first[3] != (code | 3)) return;
        codes.erase(first, first + 4);
        insert(level - 1, code / 4);
    }
}

}  // namespace rushlight

#pragma once
// Squares of a square atlas, sizes by powers of two, allocated by halving (a buddy system along a
// Morton curve).

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace rushlight {

/// Texels from the atlas's corner.
struct ShadowTile {
    uint16_t x = 0, y = 0;
    uint16_t size = 0;  ///< 0: none
    bool operator==(const ShadowTile&) const = default;
};

class ShadowTiles {
public:
    /// Forgets all tiles. `size` and `smallest` are powers of two, `size` at most 16,384 and 256
    /// times `smallest`.
    void reset(uint32_t size, uint32_t smallest);

    /// The first free square along the curve; none when no square of that size is free. `size` is a
    /// power of two.
    std::optional<ShadowTile> allocate(uint32_t size);
    void release(const ShadowTile& tile);

    uint32_t size() const { return size_; }
    uint64_t freeTexels() const { return freeTexels_; }

private:
    static constexpr uint32_t kLevels = 9;

    uint32_t levelOf(uint32_t size) const;
    void insert(uint32_t level, uint32_t code);

    uint32_t size_ = 0, smallest_ = 0;
    uint64_t freeTexels_ = 0;
    /// By level, 0 the whole atlas: Morton codes of free squares, ascending. Buddies that are all
    /// free are one square.
    std::array<std::vector<uint32_t>, kLevels> free_;
};

}  // namespace rushlight

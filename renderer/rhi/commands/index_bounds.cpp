#include "renderer/rhi/commands/index_bounds.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace rushlight {
namespace {

constexpr size_t kBlock = 64;

}  // namespace

IndexBounds::IndexBounds(std::span<const std::byte> indices) : indices_(indices) {
    std::vector<uint32_t> row(indices.size() / sizeof(uint32_t) / kBlock);
    for (size_t b = 0; b < row.size(); ++b) row[b] = scan(b * kBlock, (b + 1) * kBlock);
    while (!row.empty()) {
        const size_t step = size_t(1) << blocks_.size();
        std::vector<uint32_t> next(row.size() > step ? row.size() - step : 0);
        for (size_t b = 0; b < next.size(); ++b) next[b] = std::max(row[b], row[b + step]);
        blocks_.push_back(std::move(row));
        row = std::move(next);
    }
}

uint32_t IndexBounds::scan(size_t first, size_t end) const {
    uint32_t highest = 0;
    for (size_t i = first; i < end; ++i) {
        uint32_t index;
        std::memcpy(&index, indices_.data() + i * sizeof index, sizeof index);
        highest = std::max(highest, index);
    }
    return highest;
}

uint32_t IndexBounds::highest(size_t first, size_t count) const {
    const size_t end = first + count;
    const size_t firstBlock = (first + kBlock - 1) / kBlock, endBlock = end / kBlock;
    if (firstBlock >= endBlock) return scan(first, end);
    const size_t level = std::bit_width(endBlock - firstBlock) - 1;
    const std::vector<uint32_t>& row = blocks_[level];
    return std::max({scan(first, firstBlock * kBlock), row[firstBlock],
                     row[endBlock - (size_t(1) << level)], scan(endBlock * kBlock, end)});
}

}  // namespace rushlight

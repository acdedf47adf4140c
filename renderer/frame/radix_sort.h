#pragma once
// Least-significant-digit radix sort of items by a key of several bytes; stable.

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace rushlight {

/// Sorts by `item.key` (64 bits), ties by `item.object` (32 bits): a total order, so that the answer depends on neither
/// the order before nor the threads that made it. `scratch` keeps its memory from call to call.
template <class Item>
void radixSort(std::vector<Item>& items, std::vector<Item>& scratch) {
    constexpr size_t kSmall = 96;  // below, comparing is faster than counting
    constexpr uint32_t kDigits = 12;
    if (items.size() < kSmall) {
        std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
            return a.key != b.key ? a.key < b.key : a.object < b.object;
        });
        return;
    }
    uint64_t keyBits = 0;
    uint32_t objectBits = 0;
    for (const Item& item : items) {
        keyBits |= item.key ^ items.front().key;
        objectBits |= item.object ^ items.front().object;
    }
    scratch.resize(items.size());
    for (uint32_t digit = 0; digit < kDigits; ++digit) {
        const uint32_t shift = digit < 4 ? digit * 8 : (digit - 4) * 8;
        const auto valueOf = [&](const Item& item) -> uint32_t {
            return uint32_t(digit < 4 ? item.object >> shift : item.key >> shift) & 0xff;
        };
        if (!((digit < 4 ? objectBits >> shift : keyBits >> shift) & 0xff)) continue;
        std::array<uint32_t, 256> starts{};
        for (const Item& item : items) ++starts[valueOf(item)];
        uint32_t sum = 0;
        for (uint32_t& start : starts) start = std::exchange(sum, sum + start);
        for (const Item& item : items) scratch[starts[valueOf(item)]++] = item;
        items.swap(scratch);
    }
}

}  // namespace rushlight

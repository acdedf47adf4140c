#pragma once
// Least-significant-digit radix sort of items by a 64-bit key.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rushlight {

/// The digits of a number of which only the bits of `varying` differ between items: each begins at
/// a bit that does.
class RadixDigits {
public:
    RadixDigits(uint64_t varying, uint32_t bits) : mask_((uint64_t(1) << bits) - 1) {
        for (uint32_t shift = 0; varying >> shift;) {
            shift += uint32_t(std::countr_zero(varying >> shift));
            shifts_[count_++] = uint8_t(shift);
            shift += bits;
            if (shift >= 64) break;
        }
    }
    uint32_t count() const { return count_; }
    size_t of(uint64_t number, uint32_t digit) const {
        return size_t(number >> shifts_[digit] & mask_);
    }

private:
    uint64_t mask_;
    uint32_t count_ = 0;
    std::array<uint8_t, 8> shifts_{};
};

/// Stable. `numberOf` gives an item's 64 bits. `scratch` has as many items.
template <class Item, class NumberOf>
void radixSortBy(std::span<Item> items, std::span<Item> scratch, NumberOf numberOf) {
    constexpr uint32_t kFewBits = 8, kManyBits = 11;
    constexpr size_t kMany = 1024;  // from here on fewer digits are worth more places to count in
    uint64_t varying = 0;
    for (const Item& item : items) varying |= numberOf(item) ^ numberOf(items.front());
    const bool many = items.size() >= kMany;
    const RadixDigits digits(varying, many ? kManyBits : kFewBits);
    if (digits.count() == 0) return;
    using Counts = std::array<uint32_t, 1u << kManyBits>;
    Counts ofThis, ofNext;
    uint32_t *starts = ofThis.data(), *next = ofNext.data();
    const auto clear = [&](uint32_t* counts) {
        std::fill_n(counts, many ? Counts().size() : size_t(1) << kFewBits, 0u);
    };
    clear(starts);
    for (const Item& item : items) ++starts[digits.of(numberOf(item), 0)];
    Item *from = items.data(), *to = scratch.data();
    for (uint32_t digit = 0; digit < digits.count(); ++digit) {
        uint32_t sum = 0;
        for (size_t i = 0; sum < items.size(); ++i) starts[i] = std::exchange(sum, sum + starts[i]);
        const uint32_t following = digit + 1;
        if (following < digits.count()) {
            clear(next);
            for (size_t i = 0; i < items.size(); ++i) {
                const uint64_t number = numberOf(from[i]);
                ++next[digits.of(number, following)];
                to[starts[digits.of(number, digit)]++] = from[i];
            }
        } else {
            for (size_t i = 0; i < items.size(); ++i)
                to[starts[digits.of(numberOf(from[i]), digit)]++] = from[i];
        }
        std::swap(from, to);
        std::swap(starts, next);
    }
    if (from != items.data()) std::copy_n(from, items.size(), items.data());
}

/// Sorts by `item.key` (64 bits), ties by `item.object` (32 bits): a total order, so that the
/// answer depends on neither the order before nor the threads that made it. `scratch` keeps its
/// memory from call to call.
template <class Item>
void radixSort(std::vector<Item>& items, std::vector<Item>& scratch) {
    constexpr size_t kSmall = 96;  // below, comparing is faster than counting
    if (items.size() < kSmall) {
        std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
            return a.key != b.key ? a.key < b.key : a.object < b.object;
        });
        return;
    }
    scratch.resize(items.size());
    radixSortBy<Item>(items, scratch, [](const Item& item) { return item.key; });
    for (size_t begin = 0, end; begin < items.size(); begin = end) {
        for (end = begin + 1; end < items.size() && items[end].key == items[begin].key;) ++end;
        const std::span<Item> ties(items.data() + begin, end - begin);
        const auto before = [](const Item& a, const Item& b) { return a.object < b.object; };
        if (ties.size() < kSmall) {
            if (ties.size() > 1) std::sort(ties.begin(), ties.end(), before);
        } else if (!std::is_sorted(ties.begin(), ties.end(), before)) {
            radixSortBy<Item>(ties, std::span(scratch).first(ties.size()),
                              [](const Item& item) { return uint64_t(item.object); });
        }
    }
}

}  // namespace rushlight

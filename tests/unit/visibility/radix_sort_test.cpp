#include "renderer/visibility/radix_sort.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

namespace rushlight {
namespace {

struct Item {
    uint64_t key;
    uint32_t object;
    bool operator==(const Item&) const = default;
};

void expectSorts(std::vector<Item> items, const char* what) {
    std::vector<Item> wanted = items, scratch;
    std::ranges::sort(wanted, [](const Item& a, const Item& b) {
        return std::pair(a.key, a.object) < std::pair(b.key, b.object);
    });
    radixSort(items, scratch);
    EXPECT_EQ(items, wanted) << what << ", " << items.size() << " items";
}

TEST(RadixSort, IsATotalOrderByKeyThenObject) {
    Random random(4);
    const auto any = [&] { return uint64_t(random.next()) << 32 | random.next(); };
    for (const uint32_t count : {0u, 1u, 2u, 95u, 96u, 97u, 700u, 1023u, 1024u, 5000u}) {
        std::vector<Item> wide(count), few(count), highest(count), same(count), sparse(count);
        for (uint32_t i = 0; i < count; ++i) {
            wide[i] = {any(), i};
            few[i] = {any() % 5, any() % 2 ? i : count + 7919 * i};
            highest[i] = {any() & 3ull << 62, uint32_t(any())};
            same[i] = {42, uint32_t(any())};
            sparse[i] = {any() & 0x8000'0400'0010'0001, uint32_t(any())};
        }
        expectSorts(wide, "keys of all bits");
        expectSorts(few, "many ties");
        expectSorts(highest, "the highest bits alone");
        expectSorts(same, "one key");
        expectSorts(sparse, "bits far apart");
    }
}

TEST(RadixSort, DigitsBeginWhereBitsVary) {
    const RadixDigits digits(0x00f0'0000'0000'1008, 8);
    ASSERT_EQ(digits.count(), 3u) << "bit 3, bit 12, bits 52 to 55";
    EXPECT_EQ(digits.of(0x1008, 0), 1u);
    EXPECT_EQ(digits.of(0x1008, 1), 1u);
    EXPECT_EQ(digits.of(0x00a0'0000'0000'0000, 2), 0xau);
    EXPECT_EQ(RadixDigits(0, 8).count(), 0u);
    EXPECT_EQ(RadixDigits(~0ull, 11).count(), 6u);
}

}  // namespace
}  // namespace rushlight

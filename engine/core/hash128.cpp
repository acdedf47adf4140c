#include "engine/core/hash128.h"

#include "engine/core/hash.h"

#include <bit>
#include <cstdio>
#include <cstring>

namespace rushlight {
namespace {

constexpr uint64_t kC1 = 0x87c37b91114253d5ull;
constexpr uint64_t kC2 = 0x4cf5ad432745937full;

uint64_t mixLow(uint64_t k) { return std::rotl(k * kC1, 31) * kC2; }
uint64_t mixHigh(uint64_t k) { return std::rotl(k * kC2, 33) * kC1; }

}  // namespace

Hash128 hash128(std::span<const std::byte> bytes) {
    uint64_t low = 0, high = 0, block[2];
    const size_t whole = bytes.size() / 16 * 16;
    for (size_t i = 0; i < whole; i += 16) {
        std::memcpy(block, bytes.data() + i, 16);
        low = std::rotl(low ^ mixLow(block[0]), 27) + high;
        low = low * 5 + 0x52dce729;
        high = std::rotl(high ^ mixHigh(block[1]), 31) + low;
        high = high * 5 + 0x38495ab5;
    }
    // Zeroes after the end change nothing: mixing zero gives zero.
    block[0] = block[1] = 0;
    if (whole < bytes.size()) std::memcpy(block, bytes.data() + whole, bytes.size() - whole);
    low ^= mixLow(block[0]) ^ bytes.size();
    high ^= mixHigh(block[1]) ^ bytes.size();
    low += high;
    high += low;
    low = mixBits(low);
    high = mixBits(high);
    low += high;
    high += low;
    return {low, high};
}

std::string toText(const Hash128& hash) {
    char text[33];
    std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.low),
                  static_cast<unsigned long long>(hash.high));
    return text;
}

}  // namespace rushlight

#include "engine/core/hash.h"

#include <cstring>

namespace rushlight {

uint64_t hashBytes(const void* data, size_t size, uint64_t seed) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    uint64_t lanes[4] = {seed ^ 0x9e3779b97f4a7c15ull, seed + 0xbf58476d1ce4e5b9ull,
                         seed ^ 0x94d049bb133111ebull, seed + size};
    size_t i = 0;
    for (; i + 32 <= size; i += 32) {
        uint64_t words[4];
        std::memcpy(words, bytes + i, 32);
        for (int lane = 0; lane < 4; ++lane) {
            const uint64_t x = (lanes[lane] ^ words[lane]) * 0xff51afd7ed558ccdull;
            lanes[lane] = x ^ x >> 29;
        }
    }
    uint64_t hash = size;
    for (uint64_t lane : lanes) hash = mixBits(hash ^ lane) + lane;
    for (; i < size; i += 8) {
        uint64_t word = 0;
        std::memcpy(&word, bytes + i, size - i < 8 ? size - i : 8);
        hash = mixBits(hash ^ word) + 0x9e3779b97f4a7c15ull;
    }
    return mixBits(hash);
}

}  // namespace rushlight

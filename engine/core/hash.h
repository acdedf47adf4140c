#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rushlight {

/// A 64-bit hash of bytes: the same on every machine and run. Not for adversarial input.
uint64_t hashBytes(const void* data, size_t size, uint64_t seed = 0);

inline uint64_t hashText(std::string_view text, uint64_t seed = 0) {
    return hashBytes(text.data(), text.size(), seed);
}

/// Mixes the bits of one value; from the finaliser of MurmurHash3 (Appleby, public domain).
constexpr uint64_t mixBits(uint64_t x) {
    x ^= x >> 33;
    x *= 0xff51afd7ed558ccdull;
    x ^= x >> 33;
    x *= 0xc4ceb9fe1a85ec53ull;
    x ^= x >> 33;
    return x;
}

}  // namespace rushlight

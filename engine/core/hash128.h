#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace rushlight {

/// Names contents by their bytes. Not for adversarial input.
struct Hash128 {
    uint64_t low = 0;
    uint64_t high = 0;
    auto operator<=>(const Hash128&) const = default;
};

/// MurmurHash3_x64_128 with seed 0 (Appleby, 2011, public domain): the same on every machine and
/// run.
Hash128 hash128(std::span<const std::byte> bytes);

/// 32 hexadecimal digits.
std::string toText(const Hash128& hash);

}  // namespace rushlight

#pragma once
// RLF files that were changed, with the hashes that their bytes should have: so that what lies
// behind the hashes is tested. The offsets are those of renderer/rhi/saved/frame_file.h.

#include "engine/core/hash128.h"

#include <cstring>
#include <vector>

namespace rushlight {

inline constexpr size_t kRlfHeader = 48;
inline constexpr size_t kRlfBlobTable = kRlfHeader + 20;

template <class T>
T rlfValue(const std::vector<std::byte>& file, size_t offset) {
    T value;
    std::memcpy(&value, file.data() + offset, sizeof value);
    return value;
}

inline void putHash(std::vector<std::byte>& file, size_t offset, const Hash128& hash) {
    std::memcpy(file.data() + offset, &hash.low, 8);
    std::memcpy(file.data() + offset + 8, &hash.high, 8);
}

inline void sealDescription(std::vector<std::byte>& file) {
    const uint64_t size = rlfValue<uint64_t>(file, 24);
    if (size <= file.size() - kRlfHeader)
        putHash(file, 32, hash128(std::span(file).subspan(kRlfHeader, size)));
}

/// As far as the tables can be followed.
inline void sealFrame(std::vector<std::byte>& file) {
    if (file.size() < kRlfBlobTable + 4) return;
    const uint64_t description = rlfValue<uint64_t>(file, 24);
    if (description > file.size() - kRlfHeader) return;
    size_t blob = kRlfHeader + description;
    const uint32_t count = rlfValue<uint32_t>(file, kRlfBlobTable);
    for (uint32_t i = 0; i < count; ++i) {
        const size_t entry = kRlfBlobTable + 4 + size_t(i) * 24;
        if (entry + 24 > file.size()) break;
        const uint64_t size = rlfValue<uint64_t>(file, entry + 16);
        if (size > file.size() - blob) break;
        putHash(file, entry, hash128(std::span(file).subspan(blob, size)));
        blob += size;
    }
    sealDescription(file);
}

}  // namespace rushlight

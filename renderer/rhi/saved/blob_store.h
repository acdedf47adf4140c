#pragma once

#include "engine/core/hash128.h"

#include <deque>
#include <map>
#include <vector>

namespace rushlight {

/// Bytes that are kept once, however often they are added. They are numbered from 1 in the order in
/// which they came.
class BlobStore {
public:
    BlobStore() = default;
    BlobStore(BlobStore&&) = default;
    BlobStore& operator=(BlobStore&&) = default;

    uint32_t add(std::vector<std::byte> bytes);

    /// Keeps `file`, of which addView's views are parts: they are not copied.
    void keep(std::vector<std::byte> file) { owned_.push_back(std::move(file)); }
    std::span<const std::byte> kept() const { return owned_.back(); }
    /// For bytes whose hash is known to be right; a hash that is there already is numbered again.
    void addView(const Hash128& hash, std::span<const std::byte> bytes);

    /// The number of equal bytes, or 0.
    uint32_t find(const Hash128& hash) const {
        const auto found = numbers_.find(hash);
        return found == numbers_.end() ? 0 : found->second;
    }
    uint32_t count() const { return uint32_t(blobs_.size()); }
    const Hash128& hash(uint32_t number) const { return blobs_[number - 1].hash; }
    std::span<const std::byte> bytes(uint32_t number) const { return blobs_[number - 1].bytes; }

private:
    struct Blob {
        Hash128 hash;
        std::span<const std::byte> bytes;
    };
    std::vector<Blob> blobs_;
    std::map<Hash128, uint32_t> numbers_;
    std::deque<std::vector<std::byte>> owned_;  // moving one leaves its bytes where they are
};

}  // namespace rushlight

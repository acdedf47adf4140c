#include "renderer/rhi/saved/blob_store.h"

#include "engine/core/check.h"

#include <algorithm>

namespace rushlight {

uint32_t BlobStore::add(std::vector<std::byte> bytes) {
    const Hash128 hash = hash128(bytes);
    const auto [place, fresh] = numbers_.try_emplace(hash, count() + 1);
    if (!fresh) {
        RL_CHECK(std::ranges::equal(blobs_[place->second - 1].bytes, bytes),
                 "two different contents have one hash");
        return place->second;
    }
    owned_.push_back(std::move(bytes));
    blobs_.push_back({hash, owned_.back()});
    return count();
}

void BlobStore::addView(const Hash128& hash, std::span<const std::byte> bytes) {
    blobs_.push_back({hash, bytes});
    numbers_.try_emplace(hash, count());
}

}  // namespace rushlight

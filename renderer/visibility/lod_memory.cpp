#include "renderer/visibility/lod_memory.h"

namespace rushlight {

void LodMemory::begin(WorldHandle kept) {
    now_ = kept;
    staged_.clear();
}

void LodMemory::commit() {
    if (now_ != seen_) entries_[0].clear();
    seen_ = now_;
    for (const Change& change : staged_) {
        std::vector<Entry>& entries = entries_[change.object >> 31];
        const uint32_t slot = change.object & 0x7fffffff;
        if (slot >= entries.size()) entries.resize(slot + 1);
        entries[slot] = {change.stamp, change.lod};
    }
}

}  // namespace rushlight

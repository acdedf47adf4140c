#pragma once
// Which level of detail a view last showed of each object, so that what stands near the limit
// between two does not flicker.

#include "renderer/visibility/draw_list.h"

#include <array>
#include <span>
#include <vector>

namespace rushlight {

class LodMemory {
public:
    struct Change {
        uint32_t object = 0;  ///< of FrameWorlds
        uint32_t stamp = 0;   ///< InstanceRecord::stamp: another one and the level is not known
        uint32_t lod = 0;
    };

    /// `kept` names the first of the worlds; another one than in the last frame is not known.
    void begin(WorldHandle kept);
    /// 0 where nothing is known. From any thread.
    uint32_t last(uint32_t object, uint32_t stamp) const {
        const uint32_t world = object >> 31, slot = object & 0x7fffffff;
        if (world == 0 && now_ != seen_) return 0;
        const std::vector<Entry>& entries = entries_[world];
        return slot < entries.size() && entries[slot].stamp == stamp ? entries[slot].lod : 0;
    }
    void stage(std::span<const Change> changes) {
        staged_.insert(staged_.end(), changes.begin(), changes.end());
    }
    /// The frame was executed: what was staged since begin() is what the view showed.
    void commit();

private:
    struct Entry {
        uint32_t stamp = 0;  ///< 0: nothing is known
        uint32_t lod = 0;
    };
    WorldHandle seen_, now_;
    std::array<std::vector<Entry>, 2> entries_;  ///< by world and slot
    std::vector<Change> staged_;
};

}  // namespace rushlight

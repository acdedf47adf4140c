#pragma once
// What moved in a kept world since a view last saw it.

#include "renderer/visibility/instance_world.h"

#include <vector>

namespace rushlight {

/// One view's. Used by one thread at a time; moved() and previous() from any.
class ViewMotion {
public:
    /// Collects what moved in `world` since the last frame that was committed. Null: no world.
    /// A world that the view did not see in that frame stands still.
    void begin(WorldHandle handle, const InstanceWorld* world);
    bool moved(uint32_t slot) const { return slot < places_.size() && places_[slot] != kStill; }
    /// Where the view saw it; only of what moved.
    const mat4x3& previous(uint32_t slot) const { return previous_[places_[slot]]; }
    /// The frame that begin() was called for was executed.
    void commit() { seen_ = now_; }

    /// Moves of `world` before this number are not asked for again.
    uint64_t seenOf(WorldHandle world) const { return seen_.world == world ? seen_.moves : kAll; }
    static constexpr uint64_t kAll = ~uint64_t(0);

private:
    static constexpr uint32_t kStill = ~0u;
    struct Seen {
        WorldHandle world;
        uint64_t moves = 0;  ///< InstanceWorld::moveCount()
    };
    Seen seen_, now_;
    std::vector<uint32_t> places_;  ///< by slot: index into previous_
    std::vector<uint32_t> touched_;
    std::vector<mat4x3> previous_;
};

}  // namespace rushlight

#include "renderer/visibility/view_motion.h"

namespace rushlight {

void ViewMotion::begin(WorldHandle handle, const InstanceWorld* world) {
    for (uint32_t slot : touched_) places_[slot] = kStill;
    touched_.clear();
    previous_.clear();
    now_ = {handle, world ? world->moveCount() : 0};
    if (!world || seen_.world != handle) return;
    const uint32_t slots = world->slotCount();
    if (places_.size() < slots) places_.resize(slots, kStill);
    for (const InstanceMove& move : world->movesSince(seen_.moves)) {
        uint32_t& place = places_[move.slot];
        if (move.arrived) {
            place = kStill;
            continue;
        }
        if (place != kStill) continue;  // the view saw it before its first move
        place = uint32_t(previous_.size());
        previous_.push_back(move.from);
        touched_.push_back(move.slot);
    }
}

}  // namespace rushlight

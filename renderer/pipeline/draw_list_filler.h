#pragma once
// The instances of all lists that a frame draws, written by all threads.

#include "engine/core/jobs.h"
#include "renderer/visibility/draw_list.h"

#include <span>
#include <vector>

namespace rushlight {

class DrawListFiller {
public:
    /// Makes room for the lists in the data block of `commands`, then fills them.
    void fill(std::span<DrawList* const> lists, const FrameWorlds& worlds, CommandBuffer& commands,
              JobSystem& jobs);

private:
    std::vector<uint32_t> firstJobs_;  ///< by list, and the end
};

}  // namespace rushlight

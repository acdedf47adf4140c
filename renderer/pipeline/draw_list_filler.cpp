#include "renderer/pipeline/draw_list_filler.h"

#include <algorithm>

namespace rushlight {

// Lists are of very different lengths: a job is a run of items, and its list is looked up.
void DrawListFiller::fill(std::span<DrawList* const> lists, const FrameWorlds& worlds,
                          CommandBuffer& commands, JobSystem& jobs) {
    constexpr uint32_t kItems = DrawList::kItemsPerJob;
    firstJobs_.assign(1, 0);
    for (DrawList* list : lists) {
        list->allocate(commands);
        const uint32_t count = uint32_t(list->items.size() + kItems - 1) / kItems;
        firstJobs_.push_back(firstJobs_.back() + count);
    }
    jobs.forRanges(firstJobs_.back(), 1, [&](uint32_t begin, uint32_t end) {
        for (uint32_t job = begin; job < end; ++job) {
            const auto after = std::ranges::upper_bound(firstJobs_, job);
            const auto index = size_t(after - firstJobs_.begin()) - 1;
            const DrawList& list = *lists[index];
            const uint32_t first = (job - firstJobs_[index]) * kItems;
            const uint32_t last = std::min(first + kItems, uint32_t(list.items.size()));
            list.fill(commands, worlds, first, last);
        }
    });
}

}  // namespace rushlight

#include "renderer/visibility/occlusion/occlusion_pick.h"

#include <algorithm>

namespace rushlight {

void pickOccluders(std::span<const OccluderCandidate> candidates, uint32_t triangleBudget,
                   std::vector<uint32_t>& picked) {
    picked.clear();
    for (uint32_t i = 0; i < candidates.size(); ++i)
        if (candidates[i].screenArea > 0 && candidates[i].triangles > 0 &&
            candidates[i].triangles <= triangleBudget)
            picked.push_back(i);
    const auto worth = [&](uint32_t i) {
        return candidates[i].screenArea / float(candidates[i].triangles);
    };
    std::ranges::sort(picked, [&](uint32_t a, uint32_t b) {
        return worth(a) != worth(b) ? worth(a) > worth(b) : a < b;
    });
    uint32_t left = triangleBudget;
    std::erase_if(picked, [&](uint32_t i) {
        if (candidates[i].triangles > left) return true;
        left -= candidates[i].triangles;
        return false;
    });
}

}  // namespace rushlight

#pragma once
// Which objects are worth filling as occluders.

#include <cstdint>
#include <span>
#include <vector>

namespace rushlight {

struct OccluderCandidate {
    float screenArea = 0;  ///< pixels that it covers, roughly
    uint32_t triangles = 0;
};

/// Puts into `picked` the candidates with the most area for each of their triangles, best first,
/// ties by index, as long as their triangles fit into `triangleBudget`; one that does not fit is
/// passed over. Candidates without a positive area or without triangles are never picked. Memory of
/// `picked` is kept.
void pickOccluders(std::span<const OccluderCandidate> candidates, uint32_t triangleBudget,
                   std::vector<uint32_t>& picked);

}  // namespace rushlight

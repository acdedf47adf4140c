#pragma once
// Which objects cast into the shadow views of point and spot lights: any number of views in one
// walk over the worlds' hierarchies, 32 at a time as neighbours (a cube's faces, lights in order)
// that descend together. Apart from the camera's and the cascades' (Visibility), as these views are
// asked for only when something near them changed.

#include "renderer/shadows/shadow_view.h"
#include "renderer/visibility/draw_list.h"

#include <span>
#include <vector>

namespace rushlight {

class ShadowVisibility {
public:
    struct Inputs {
        FrameWorlds worlds;  ///< prepared
        const GeometryStore* geometry = nullptr;
        std::span<const ShadowView* const> views;
        uint32_t indices = 3;  ///< as bits: which of the worlds' indices (InstanceWorld::indices)
                               ///< to look into
    };
    /// The casters of one view: those that hide light, or those that colour it.
    struct Found {
        uint64_t hash = 0;  ///< of which objects, in which state, how detailed; 0 for none
        std::span<const VisibleItem> items;  ///< not in order; until the next gather()
    };

    /// The same for any number of threads. Keeps its memory.
    void gather(const Inputs& inputs, JobSystem& jobs);
    Found found(uint32_t view) const { return foundIn(view); }
    Found foundGlass(uint32_t view) const { return foundIn(uint32_t(ranges_.size() / 2) + view); }

private:
    struct BlockVisit {
        SpatialIndex::Visit visit;
        uint32_t firstView;
        uint8_t world, index;
    };
    struct Cast {
        VisibleItem item;
        uint32_t range;  ///< the view; of what colours light, after all views
        uint32_t stamp;
    };
    struct Range {
        uint32_t first = 0, count = 0;
        uint64_t hash = 0;
    };
    void findBlocks(const Inputs&);
    void testBlock(const Inputs&, const BlockVisit&, std::vector<Cast>& casts) const;
    void sortByView(uint32_t viewCount);
    Found foundIn(uint32_t range) const;

    std::vector<CullVolume> volumes_;
    std::vector<SpatialIndex::Visit> visits_;
    std::vector<BlockVisit> blocks_;
    std::vector<std::vector<Cast>> chunks_;
    uint32_t chunkCount_ = 0;
    std::vector<Range> ranges_;
    std::vector<VisibleItem> items_;
};

}  // namespace rushlight

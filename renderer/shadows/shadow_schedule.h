#pragma once
// Which of the shadow atlas's squares have to be drawn in a frame, and what into them. A square
// whose view and casters are those that it was last drawn with is kept. Casters that stand still
// and those that move are told apart (by the worlds' indices): where something moves before a light
// that stands, what stands still is kept in a layer of its own and copied, and only what moves is
// drawn.

#include "renderer/shadows/shadow_lights.h"
#include "renderer/shadows/shadow_visibility.h"

namespace rushlight {

/// A square that is drawn: cleared, or filled from the layer of still casters; then the casters.
struct ShadowDraw {
    ShadowFace* face = nullptr;
    bool fromLayer = false;
    DrawList* layerCasters = nullptr;  ///< into the layer, which is cleared there first; null: it
                                       ///< is good
    DrawList* still = nullptr;         ///< into the atlas
    DrawList* moving = nullptr;
    BufferRange viewUniforms;  ///< the caller's
};

/// A square of the map of colours that is drawn: cleared; then what colours light.
struct GlassDraw {
    const ShadowFace* face = nullptr;
    DrawList* casters = nullptr;  ///< null: none
    BufferRange viewUniforms;     ///< the caller's
};

class ShadowSchedule {
public:
    struct Inputs {
        FrameWorlds worlds;  ///< prepared
        WorldHandle world;   ///< which the first of them is
        const GeometryStore* geometry = nullptr;
        std::span<ShadowFace* const> faces;
        bool caching = true;
        bool hasGlass = false;  ///< something in the worlds colours light
    };

    /// Notes in the faces what will have been drawn. The lists are arranged.
    void plan(const Inputs& inputs, JobSystem& jobs);
    std::span<ShadowDraw> draws() { return draws_; }
    /// Inputs::hasGlass: without it the map of colours is left as it is and not to be read.
    bool hasGlass() const { return hasGlass_; }
    std::span<GlassDraw> glassDraws() { return glassDraws_; }
    uint32_t drawn() const { return drawn_; }  ///< faces of which anything is drawn
    uint32_t cached() const { return cached_; }
    /// Calls `f` with each list that is drawn.
    template <class F>
    void forEachList(F&& f) {
        for (uint32_t i = 0; i < usedLists_; ++i) f(lists_[i]);
    }

private:
    /// Of the worlds' indices that hold what stands still, or what moves.
    uint64_t versionOf(const Inputs&, uint32_t index) const;
    /// Brings the faces' hashes of the casters in that index up to date.
    void hashCasters(const Inputs&, uint32_t index, JobSystem& jobs);
    void chooseDraws(const Inputs&);
    void listCasters(const Inputs&, uint32_t index, JobSystem& jobs);
    bool chooseGlass(const Inputs&, ShadowFace&);
    void listGlass(const Inputs&, JobSystem& jobs);

    ShadowVisibility visibility_;
    struct Request {
        uint32_t draw;
        DrawList* ShadowDraw::*list;
    };
    std::vector<ShadowFace*> asked_;
    std::array<std::vector<Request>, 2> requests_;  ///< of casters in each of the worlds' indices
    std::vector<const ShadowView*> views_;
    std::vector<ShadowDraw> draws_;
    std::vector<GlassDraw> glassDraws_;
    bool hasGlass_ = false;
    std::vector<DrawList> lists_;
    uint32_t usedLists_ = 0;
    uint32_t drawn_ = 0, cached_ = 0;
};

}  // namespace rushlight

#pragma once
// Which point, spot and area lights of a frame have shadow maps, where in the atlas, and how large.
// A light keeps its squares from frame to frame: their views do not depend on the camera, and their
// size follows what the camera sees in steps of two with a wide dead band, so that what they hold
// stays good while only the camera moves.

#include "renderer/frame/frame_settings.h"
#include "renderer/frame/lights.h"
#include "renderer/geometry/view_math.h"
#include "renderer/shadows/shadow_source.h"
#include "renderer/shadows/shadow_tiles.h"
#include "renderer/shadows/shadow_view.h"

#include <array>
#include <span>
#include <vector>

namespace rushlight {

/// One square of the atlas and what is known of its contents. 0 stands for "nothing known" in keys
/// and hashes.
struct ShadowFace {
    ShadowTile tile;
    ShadowView view;
    uint64_t viewKey = 0;  ///< of all that decides what the view shows, but for the casters
    uint64_t stillVersion = 0, movingVersion = 0;  ///< of the worlds when the hashes below were
                                                   ///< made
    uint64_t stillHash = 0, movingHash = 0;        ///< of the casters
    uint64_t drawn = 0;                            ///< what the atlas holds there
    uint64_t drawnView = 0;                        ///< viewKey of that
    uint64_t drawnStill = 0;                       ///< what the layer of still casters holds there
    uint64_t stillGlass = 0, movingGlass = 0;      ///< hashes as above, of the casters that colour
                                                   ///< light
    uint64_t drawnGlass = 0;                       ///< what the map of their colours holds there
};

/// The atlas as a view remembers it: who has which squares, and what they hold. A value.
struct ShadowAtlasHistory {
    /// A light that has, or lately had, squares of the atlas.
    struct Slot {
        uint64_t identity = 0;  ///< hash of where the light is and what it reaches; 0: it is free
        uint32_t light = 0;     ///< index in the last frame that it was seen in; area lights after
                                ///< the others
        uint64_t lastSeen = 0;  ///< frame
        uint32_t wish = 0;      ///< log2 of the texels a side that its size on screen asks for,
                                ///< changed reluctantly
        uint32_t level = 0;     ///< log2 of its tiles' size; 0: it has none
        uint32_t faceCount = 0;
        std::array<ShadowFace, 6> faces;
    };
    ShadowTiles tiles;
    std::vector<Slot> slots;
    uint32_t bias = 0;  ///< quarters of a level below the largest that tiles keep to, so that all
                        ///< fit
    uint64_t frame = 0;

    /// What the maps hold is not known any more.
    void forgetContents();
};

class ShadowLights {
public:
    static constexpr uint32_t kSmallestTile = 64;

    struct Inputs {
        const CameraMatrices* camera = nullptr;
        uint32_t targetHeight = 0;
        std::span<const PunctualLight> punctual;
        const FrameSettings* settings = nullptr;
        std::span<const AreaLight> area = {};
        uint32_t firstFace = 0;  ///< index of the first of gpuFaces() where shaders read them
    };
    struct Counts {
        uint32_t lights = 0;   ///< that reach into the view and have a shadow
        uint32_t reduced = 0;  ///< of those, with fewer texels than their size on screen asks for
        uint32_t without = 0;  ///< that should have one and found no room
    };

    /// Chooses and places; then faces() are the views of this frame's lights. They point into
    /// `history`, which the frame goes on with.
    Counts select(const Inputs& inputs, ShadowAtlasHistory& history);
    std::span<ShadowFace* const> faces() const { return faces_; }
    /// Of each punctual light: the record that shaders look up, or -1. Empty when no light has a
    /// shadow.
    std::span<const int32_t> records() const {
        return anyRecord_ ? std::span(records_) : std::span<const int32_t>();
    }
    /// Of each area light: the index of its first face, or -1. Empty when none has a shadow.
    std::span<const int32_t> areaRecords() const {
        return anyAreaRecord_ ? std::span(areaRecords_) : std::span<const int32_t>();
    }
    std::span<const GpuShadowFace> gpuFaces() const { return gpuFaces_; }
    uint32_t atlasSize() const { return history_ ? history_->tiles.size() : 0; }

private:
    using Slot = ShadowAtlasHistory::Slot;
    /// A light of this frame that should have a shadow.
    struct Wanted {
        uint32_t light;
        uint32_t slot;
        float priority;
        float wish;
        ShadowSource source;
    };
    void begin(const FrameSettings&);
    void findWanted(const Inputs&);
    void addIfWanted(const Inputs&, uint32_t light, float nearest, const ShadowSource&);
    void matchSlots(size_t lightCount);
    uint32_t findSlot(const Wanted&);
    uint32_t freeSlot();
    void updateWishes();
    uint32_t levelOf(const Slot&, uint32_t bias) const;
    uint64_t texelsAt(uint32_t bias) const;
    void chooseBias();
    void dropTooMany();
    void placeTiles();
    bool placeTiles(Slot& slot);
    bool evictOldest();
    void releaseTiles(Slot& slot);
    void takeOver(ShadowFace& face, const Slot& slot, uint32_t index) const;
    void fillFaces(const Inputs&);
    void fillFace(const Inputs&, const Wanted&, uint32_t index);

    ShadowAtlasHistory* history_ = nullptr;
    std::vector<Slot> before_;  ///< a cut: of the frame before it
    std::vector<uint32_t> slotOfLight_;
    std::vector<Wanted> wanted_;
    std::vector<ShadowFace*> faces_;
    std::vector<int32_t> records_, areaRecords_;
    std::vector<GpuShadowFace> gpuFaces_;
    bool anyRecord_ = false, anyAreaRecord_ = false;
    uint32_t largestLevel_ = 0;
    Counts counts_;
};

}  // namespace rushlight

#pragma once
// Cascaded shadow maps of the suns: depth from the light, one layer a cascade. A cascade whose view
// and casters hash as they did when it was last drawn is kept as it is.

#include "renderer/passes/surface/surface_pipelines.h"
#include "renderer/plan/image_history.h"
#include "renderer/visibility/shadow_cascades.h"

#include <array>

namespace rushlight {

/// Four of the first sun, two of each of three others.
inline constexpr uint32_t kMaxSunViews = 10;

/// What the layers of a view's map hold. A value.
struct SunShadowHistory {
    uint32_t generation = 0;                        ///< of the image that the contents are of
    std::array<uint64_t, kMaxSunViews> contents{};  ///< by layer; 0: not known

    /// The contents, where `image` is still the one that they are of.
    std::array<uint64_t, kMaxSunViews>& of(const ImageHistory::Kept& image) {
        if (generation != image.generation) *this = {image.generation, {}};
        return contents;
    }
};

class ShadowPass {
public:
    struct View {
        const ShadowCascade* cascade = nullptr;
        DrawList* casters = nullptr;
        BufferRange uniforms;
    };
    struct Inputs {
        std::span<const View> views;  ///< at most kMaxSunViews; each has a layer of the map
        uint32_t resolution = 0;
        DrawBinder binder;
        WorldHandle world;  ///< that the casters come from
        const FrameWorlds* worlds = nullptr;
        bool caching = true;
        ImageHistory* images = nullptr;       ///< the view's
        SunShadowHistory* history = nullptr;  ///< of the frame before; becomes this frame's
    };
    struct Outputs {
        ImageId map;              ///< D32F array, reversed: 1 nearest to the light
        uint32_t drawnViews = 0;  ///< as bits; the others' casters need no data
        uint32_t drawn = 0;
        uint32_t cached = 0;
        std::span<const uint64_t> contents;  ///< by view: another number when what the map holds
                                             ///< changes
    };

    explicit ShadowPass(Device& device);
    Result<Outputs> add(FramePlan& plan, const Inputs& inputs);

private:
    SurfacePipelines pipelines_;
};

}  // namespace rushlight

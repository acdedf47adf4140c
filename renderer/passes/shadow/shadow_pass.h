#pragma once
// Cascaded shadow maps of the suns: depth from the light, one layer a cascade. A cascade whose view
// and casters hash as they did when it was last drawn is kept as it is.

#include "renderer/passes/surface/surface_pipelines.h"
#include "renderer/plan/frame_plan.h"
#include "renderer/visibility/shadow_cascades.h"

#include <array>

namespace rushlight {

class ShadowPass {
public:
    static constexpr uint32_t kMaxViews = 10;  ///< four of the first sun, two of each of three
                                               ///< others

    struct View {
        const ShadowCascade* cascade = nullptr;
        DrawList* casters = nullptr;
        BufferRange uniforms;
    };
    struct Inputs {
        std::span<const View> views;  ///< at most kMaxViews; each has a layer of the map
        uint32_t resolution = 0;
        DrawBinder binder;
        WorldHandle world;  ///< that the casters come from
        bool caching = true;
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
    ~ShadowPass();
    Result<Outputs> add(FramePlan& plan, const Inputs& inputs);
    /// Shader or mesh contents changed: nothing cached is good any more.
    void forget() { hashes_ = {}; }

private:
    Result<void> reserve(uint32_t resolution, uint32_t layers);

    Device& device_;
    SurfacePipelines pipelines_;
    TextureHandle map_;
    uint32_t resolution_ = 0, layers_ = 0;
    std::array<uint64_t, kMaxViews> hashes_{};
};

}  // namespace rushlight

#pragma once
// Cascaded shadow maps of the sun: depth from the light, one layer a cascade. A cascade whose view and casters hash as
// they did when it was last drawn is kept as it is.

#include "renderer/frame/frame_plan.h"
#include "renderer/frame/shadow_cascades.h"
#include "renderer/passes/surface_pipelines.h"

#include <array>

namespace rushlight {

class ShadowPass {
public:
    struct Inputs {
        const ShadowCascades* cascades = nullptr;
        std::array<DrawList*, 4> casters{};
        std::array<BufferRange, 4> viewUniforms{};
        DrawBinder binder;
        WorldHandle world;  ///< that the casters come from
        bool caching = true;
    };
    struct Outputs {
        ImageId map;  ///< D32F array, reversed: 1 nearest to the light
        uint32_t drawnCascades = 0;  ///< as bits; the others' casters need no data
        uint32_t drawn = 0;
        uint32_t cached = 0;
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
    std::array<uint64_t, 4> hashes_{};
};

}  // namespace rushlight

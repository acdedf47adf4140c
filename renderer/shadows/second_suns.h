#pragma once
// Shadows of the suns after the first that casts: cascades of their own, fewer, in the layers of
// the shadow map after the first sun's. Apart from that one's (Visibility, LightingUniforms), so
// that a frame with one sun knows nothing of them.

#include "renderer/frame/lights.h"
#include "renderer/shadows/shadow_visibility.h"
#include "renderer/visibility/shadow_cascades.h"

#include <array>

namespace rushlight {

/// As shaders/common/light/second_suns.glsl reads it: eight texels of RGBA32F, the fields those of
/// LightingUniforms.
struct GpuSecondSun {
    vec4 rows[3];
    vec4 settings;
    vec4 softness;
    vec4 cascades[2];
    vec4 unused;
};
static_assert(sizeof(GpuSecondSun) == 128);

class SecondSuns {
public:
    static constexpr uint32_t kMost = kMaxDirectionalLights - 1;
    static constexpr uint32_t kCascades = 2;  ///< of each, at most

    struct Inputs {
        const CameraMatrices* camera = nullptr;
        std::span<const DirectionalLight> directional;
        int sun = -1;                ///< the first that casts
        ShadowCascadeDesc cascades;  ///< that one's
        FrameWorlds worlds;          ///< prepared
        const GeometryStore* geometry = nullptr;
        const FrameSettings* settings = nullptr;
    };

    /// Chooses the suns and their cascades, and lists what casts into them; the lists are arranged.
    void plan(const Inputs& inputs, JobSystem& jobs);
    void clear() { suns_ = 0; }

    uint32_t count() const { return suns_; }
    uint32_t cascadesOfEach() const { return suns_ > 0 ? cascades_[0].count : 0; }
    uint32_t viewCount() const { return count() * cascadesOfEach(); }
    const ShadowCascade& cascade(uint32_t view) const {
        return cascades_[view / cascadesOfEach()].cascades[view % cascadesOfEach()];
    }
    DrawList& casters(uint32_t view) { return lists_[view]; }
    DrawList& glass(uint32_t view) { return glass_[view]; }
    std::span<const GpuSecondSun> gpu() const { return {gpu_.data(), suns_}; }

private:
    void makeView(const Inputs&, const ShadowCascades&, uint32_t cascade, ShadowView&) const;

    uint32_t suns_ = 0;
    std::array<ShadowCascades, kMost> cascades_;
    std::array<ShadowView, kMost * kCascades> views_;
    std::array<DrawList, kMost * kCascades> lists_, glass_;
    std::array<GpuSecondSun, kMost> gpu_;
    std::vector<const ShadowView*> asked_;
    ShadowVisibility visibility_;
};

/// In which order shaders expect the directional lights: those that cast first when shadows are on
/// (`sun` >= 0), else and among themselves as they are given.
std::array<uint8_t, kMaxDirectionalLights> sunOrder(std::span<const DirectionalLight> lights,
                                                    int sun);

}  // namespace rushlight

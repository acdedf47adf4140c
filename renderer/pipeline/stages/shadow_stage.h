#pragma once
// The shadow views of a frame: the suns' cascades, and the faces of point, spot and area lights.

#include "renderer/passes/shadow/shadow_glass_pass.h"
#include "renderer/pipeline/frame_context.h"
#include "renderer/shadows/second_suns.h"
#include "renderer/shadows/shadow_schedule.h"
#include "renderer/visibility/visibility.h"

#include <array>

namespace rushlight {

class ShadowStage {
public:
    /// The suns' cascades, which visibility is worked out for.
    struct Views {
        int sun = -1;  ///< index of the first directional light that casts; -1: none
        const ShadowCascades* cascades = nullptr;
        const SecondSuns* others = nullptr;
    };
    struct Inputs {
        Views views;
        Visibility::Lists* lists = nullptr;  ///< of the first sun's casters
    };
    struct Outputs {
        ImageId sunMap, sunGlass, atlas, atlasGlass;  ///< null where there is none
        uint32_t sunViews = 0;                        ///< layers of the sun's map that are in use
        BufferRange records;  ///< of other suns (GpuSecondSun), then of faces (GpuShadowFace)
        bool punctualCast = false, areaCast = false;  ///< some have shadows, in view or not
        std::span<const int32_t> punctual, area;      ///< their records by light, see ShadowLights
        uint32_t drawn = 0, cached = 0;               ///< views
        ShadowLights::Counts lights;
    };

    explicit ShadowStage(Device& device)
        : sunPass_(device), atlasPass_(device), glassPass_(device) {}
    /// Good until the next frame.
    Views chooseViews(FrameContext& frame);
    Result<Outputs> add(FrameContext& frame, const Inputs& inputs);

private:
    void scheduleLights(FrameContext& frame, const Inputs& inputs, Outputs& out);
    Result<void> addSun(FrameContext& frame, const Inputs& inputs, Outputs& out);
    Result<void> addSunGlass(FrameContext& frame, const ShadowPass::Outputs& opaque,
                             uint32_t resolution, Outputs& out);
    Result<void> addLights(FrameContext& frame, Outputs& out);
    void uploadRecords(FrameContext& frame, const SecondSuns& others, Outputs& out);

    ShadowPass sunPass_;
    ShadowAtlasPass atlasPass_;
    ShadowGlassPass glassPass_;
    // Worked out anew each frame; they keep their memory.
    ShadowCascades cascades_;
    SecondSuns others_;
    ShadowLights lights_;
    ShadowSchedule schedule_;
    std::array<ShadowPass::View, kMaxSunViews> sunViews_;
    std::array<ShadowGlassPass::SunView, kMaxSunViews> glassViews_;
    std::vector<GpuShadowFace> records_;
};

}  // namespace rushlight

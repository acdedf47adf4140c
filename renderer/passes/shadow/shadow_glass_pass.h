#pragma once
// The colours that light takes on its way, beside the shadow maps: of what light goes through
// before the opaque casters, the product of the colours, and the depth where it first does
// (shaders/common/shadow/glass_shadow.glsl). Maps have the layout of the shadow maps, and are made
// when there is something to be drawn into them.

#include "renderer/passes/shadow/shadow_atlas_pass.h"
#include "renderer/passes/shadow/shadow_pass.h"
#include "renderer/passes/surface/surface_pipelines.h"
#include "renderer/shadows/shadow_schedule.h"

#include <array>

namespace rushlight {

class ShadowGlassPass {
public:
    struct SunView {
        DrawList* casters = nullptr;  ///< what colours light; arranged
        BufferRange uniforms;
        uint64_t opaque = 0;  ///< of what the shadow map holds: another number when that changes
    };
    struct SunInputs {
        std::span<const SunView> views;  ///< by layer
        ImageId map;                     ///< the shadow map, drawn before
        uint32_t resolution = 0;
        DrawBinder binder;
        bool caching = true;
        bool hasGlass = false;  ///< something in the worlds colours light
        const FrameWorlds* worlds = nullptr;
        ImageHistory* images = nullptr;       ///< the view's
        SunShadowHistory* history = nullptr;  ///< of the frame before; becomes this frame's
    };
    struct SunOutputs {
        ImageId glass;            ///< RGBA16F array; null without anything that colours light
        uint32_t drawnViews = 0;  ///< as bits; the others' casters need no data
    };
    struct AtlasInputs {
        std::span<const GlassDraw> draws;  ///< until the plan is recorded
        ImageId atlas;                     ///< drawn before
        uint32_t size = 0;
        DrawBinder binder;
        const FrameWorlds* worlds = nullptr;
        ImageHistory* images = nullptr;       ///< the view's
        AtlasGenerations* history = nullptr;  ///< of the frame before; becomes this frame's
    };

    explicit ShadowGlassPass(Device& device);
    Result<SunOutputs> addSun(FramePlan& plan, const SunInputs& inputs);
    /// RGBA16F array of one layer.
    Result<ImageId> addAtlas(FramePlan& plan, const AtlasInputs& inputs);

private:
    struct AtlasPayload {
        std::span<const GlassDraw> draws;
        DrawBinder binder;
        PipelineHandle clear;
    };
    static void recordAtlas(const AtlasPayload&, CommandBuffer&);
    Result<void> createClear();

    Device& device_;
    SurfacePipelines sunPipelines_, atlasPipelines_;
    PipelineHandle clear_;
};

}  // namespace rushlight

#pragma once
// Opaque and alpha-masked surfaces into an image of surface properties. Layout:
// shaders/common/surface/gbuffer.glsl.

#include "renderer/passes/surface/surface_pipelines.h"
#include "renderer/plan/frame_plan.h"

namespace rushlight {

class GBufferPass {
public:
    struct Inputs {
        DrawList* draws = nullptr;  ///< opaque; batches get their pipelines
        DrawBinder binder;
        BufferRange viewUniforms;  ///< interop::ViewUniforms
        uint32_t width = 0, height = 0;
        DecalBindings decals;
        const FrameWorlds* worlds = nullptr;  ///< whose objects may be drawn
    };
    struct Outputs {
        ImageId target0, target1, target2;  ///< RGBA8
        ImageId depth;                      ///< D32F, reversed
    };

    explicit GBufferPass(Device& device);
    Result<Outputs> add(FramePlan& plan, const Inputs& inputs);

private:
    SurfacePipelines pipelines_;
};

}  // namespace rushlight

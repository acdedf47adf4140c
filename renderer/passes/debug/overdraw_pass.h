#pragma once
// How often the G-buffer is written at each pixel: the same surfaces in the same order, counted in
// place of drawn.

#include "renderer/passes/surface/surface_pipelines.h"
#include "renderer/plan/frame_plan.h"

namespace rushlight {

class OverdrawPass {
public:
    struct Inputs {
        DrawList* draws = nullptr;  ///< batches get this pass's pipelines: nothing else of the
                                    ///< frame may draw them
        DrawBinder binder;
        BufferRange viewUniforms;  ///< interop::ViewUniforms
        uint32_t width = 0, height = 0;
    };
    struct Outputs {
        ImageId count;  ///< R16F: fragments that passed the depth test and were not cut out
    };

    explicit OverdrawPass(Device& device);
    Result<Outputs> add(FramePlan& plan, const Inputs& inputs);

private:
    SurfacePipelines pipelines_;
};

}  // namespace rushlight

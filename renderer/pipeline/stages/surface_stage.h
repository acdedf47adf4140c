#pragma once
// Opaque surfaces into the G-buffer, with the decals on them.

#include "renderer/lighting/clusters/decal_clusters.h"
#include "renderer/passes/surface/gbuffer_pass.h"
#include "renderer/pipeline/frame_context.h"
#include "renderer/visibility/visibility.h"

namespace rushlight {

class SurfaceStage {
public:
    struct Inputs {
        Visibility::Lists* lists = nullptr;
    };
    struct Outputs {
        GBufferPass::Outputs gbuffer;
        BufferRange viewUniforms;  ///< interop::ViewUniforms of the camera
        DecalBindings decals;
    };

    explicit SurfaceStage(Device& device);
    Result<Outputs> add(FrameContext& frame, const Inputs& inputs);

private:
    DecalBindings bindDecals(FrameContext& frame, interop::ViewUniforms& view);

    GBufferPass gbufferPass_;
    SamplerHandle decalSampler_;
    DecalClusters decalClusters_;  ///< worked out anew each frame
};

}  // namespace rushlight

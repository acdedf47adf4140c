#pragma once
// What passes that draw one triangle over their target have in common:
// shaders/common/fullscreen.vert.

#include "renderer/plan/frame_plan.h"
#include "shaders/interop/uniforms.h"

#include <span>
#include <string_view>
#include <vector>

namespace rushlight {

/// The pipelines of one fragment shader, by their #defines. The texts must be static.
class FullscreenPipelines {
public:
    FullscreenPipelines(Device& device, std::string_view label, std::string_view fragmentShader,
                        BlendMode blend = BlendMode::off,
                        std::string_view vertexShader = "common/fullscreen.vert")
        : device_(device),
          label_(label),
          fragmentShader_(fragmentShader),
          vertexShader_(vertexShader),
          blend_(blend) {}

    Result<PipelineHandle> find(std::span<const std::string_view> defines);

private:
    struct Entry {
        std::vector<std::string_view> defines;
        PipelineHandle pipeline;
    };
    Device& device_;
    std::string_view label_, fragmentShader_, vertexShader_;
    BlendMode blend_;
    std::vector<Entry> entries_;
};

/// Samplers that clamp to the edge, without mip levels.
SamplerHandle linearClampSampler(Device& device);
SamplerHandle nearestClampSampler(Device& device);
/// The same with mip levels.
SamplerHandle trilinearClampSampler(Device& device);

inline BufferRange appendUniforms(CommandBuffer& data, const interop::PassUniforms& uniforms) {
    return data.append(std::span<const interop::PassUniforms>(&uniforms, 1));
}

}  // namespace rushlight

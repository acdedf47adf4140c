#include "renderer/passes/fullscreen.h"

#include "shaders/interop/bindings.h"

#include <algorithm>

namespace rushlight {
namespace {

SamplerHandle clampSampler(Device& device, TextureFilter filter) {
    SamplerDesc desc;
    desc.wrapU = desc.wrapV = TextureWrap::clampToEdge;
    desc.magnify = desc.minify = desc.mipmap = filter;
    desc.useMipmaps = false;
    return device.createSampler(desc);
}

}  // namespace

SamplerHandle linearClampSampler(Device& device) {
    return clampSampler(device, TextureFilter::linear);
}

SamplerHandle nearestClampSampler(Device& device) {
    return clampSampler(device, TextureFilter::nearest);
}
SamplerHandle trilinearClampSampler(Device& device) {
    SamplerDesc desc;
    desc.wrapU = desc.wrapV = TextureWrap::clampToEdge;
    return device.createSampler(desc);
}

Result<PipelineHandle> FullscreenPipelines::find(std::span<const std::string_view> defines) {
    for (const Entry& entry : entries_)
        if (std::ranges::equal(entry.defines, defines)) return entry.pipeline;
    PipelineDesc desc;
    desc.label = label_;
    desc.vertexShader = vertexShader_;
    desc.fragmentShader = fragmentShader_;
    desc.defines = defines;
    desc.blend = blend_;
    auto pipeline = device_.createPipeline(desc);
    if (!pipeline) return pipeline;
    entries_.push_back({{defines.begin(), defines.end()}, *pipeline});
    return pipeline;
}

}  // namespace rushlight

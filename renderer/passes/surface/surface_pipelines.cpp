#include "renderer/passes/surface/surface_pipelines.h"

#include "engine/core/hash.h"
#include "renderer/materials/surface_variant.h"
#include "shaders/interop/bindings.h"

#include <algorithm>

namespace rushlight {
namespace {

CullMode cullMode(uint32_t flags) {
    if (flags & kDoubleSided) return CullMode::none;
    return flags & kMirrored ? CullMode::front : CullMode::back;
}

}  // namespace

void DecalBindings::bind(PassBuilder& pass) const {
    if (!*this) return;
    pass.texture(RL_TEXTURE_DECAL_COLOR, color, sampler);
    pass.texture(RL_TEXTURE_DECAL_DETAIL, detail, sampler);
    pass.texels(RL_TEXTURE_DECALS, Format::rgba32f, records);
    pass.texels(RL_TEXTURE_DECAL_LISTS, Format::r32ui, lists);
}

void bindMaterials(PassBuilder& pass, const DrawBinder& binder) {
    pass.texels(RL_TEXTURE_MATERIALS, Format::rgba32ui, binder.materials->buffer());
}

Result<void> SurfacePipelines::assign(DrawList& list,
                                      std::span<const std::string_view> extraDefines) {
    for (DrawBatch& batch : list.batches) {
        auto pipeline = find(batch.surfaceFlags, extraDefines);
        if (!pipeline) return tl::unexpected(pipeline.error());
        batch.pipeline = *pipeline;
    }
    return {};
}

Result<void> SurfacePipelines::prepare(const FrameWorlds& worlds,
                                       uint32_t (*flagsOf)(uint32_t flags),
                                       std::span<const std::string_view> extraDefines) {
    uint64_t seen = 1;
    worlds.forEachVariant([&](uint32_t flags) { seen = mixBits(seen + flags); });
    for (std::string_view define : extraDefines)
        seen = hashBytes(define.data(), define.size(), seen);
    if (seen == prepared_) return {};
    Result<void> result;
    worlds.forEachVariant([&](uint32_t flags) {
        const uint32_t own = flagsOf(flags);
        if (!result || own == kNoPipeline) return;
        if (const auto made = find(own & kSurfaceFlags, extraDefines); !made)
            result = tl::unexpected(made.error());
    });
    if (result) prepared_ = seen;
    return result;
}

Result<PipelineHandle> SurfacePipelines::find(uint32_t surfaceFlags,
                                              std::span<const std::string_view> extraDefines) {
    const uint32_t flags = surfaceFlags & desc_.usedFlags;
    const bool depthOnly = desc_.fragmentShader == "passes/shadow/depth.frag";
    const bool colorless = depthOnly || desc_.fragmentShader == "passes/shadow/shadow_glass.frag";
    const bool positionsOnly = depthOnly && !(flags & kAlphaMask);
    for (const Entry& entry : entries_)
        if (entry.flags == flags && std::ranges::equal(entry.extraDefines, extraDefines))
            return entry.pipeline;

    std::vector<std::string_view> defines(extraDefines.begin(), extraDefines.end());
    if (!positionsOnly) appendDefines(flags, defines);
    if (colorless) defines.push_back("DEPTH_ONLY");
    PipelineDesc desc;
    desc.label = desc_.label;
    desc.vertexShader = positionsOnly ? "passes/shadow/depth.vert" : desc_.vertexShader;
    desc.fragmentShader = desc_.fragmentShader;
    desc.defines = defines;
    desc.layout = positionsOnly       ? VertexLayout::position
                  : flags & kExtended ? VertexLayout::extended
                                      : VertexLayout::standard;
    desc.movingInstances = flags & kMoving;
    desc.cull = cullMode(flags);
    desc.depthClamp = desc_.depthClamp;
    desc.depthBias = desc_.depthBias;
    desc.depthBiasSlope = desc_.depthBiasSlope;
    desc.depthTest = desc_.depthTest;
    desc.depthWrite = desc_.depthWrite;
    desc.blend = flags & kTransmission ? desc_.transmissive : desc_.blend;
    auto pipeline = device_.createPipeline(desc);
    if (!pipeline) return pipeline;
    entries_.push_back({flags, {extraDefines.begin(), extraDefines.end()}, *pipeline});
    return pipeline;
}

}  // namespace rushlight

#include "renderer/passes/shadow/shadow_atlas_pass.h"

#include "renderer/passes/fullscreen.h"
#include "renderer/passes/shadow/caster_flags.h"
#include "shaders/interop/bindings.h"

#include <algorithm>
#include <utility>

namespace rushlight {
namespace {

void enter(const ShadowDraw& draw, CommandBuffer& commands) {
    const ShadowTile& t = draw.face->tile;
    commands.push(SetViewport{t.x, t.y, t.size, t.size});
    commands.push(SetScissor{t.x, t.y, t.size, t.size});
}

}  // namespace

ShadowAtlasPass::ShadowAtlasPass(Device& device)
    : device_(device),
      pipelines_(device, {.label = "shadow.atlas",
                          .vertexShader = "passes/surface/surface.vert",
                          .fragmentShader = "passes/shadow/depth.frag"}),
      nearest_(nearestClampSampler(device)) {}

Result<void> ShadowAtlasPass::createPipelines() {
    if (copy_) return {};
    constexpr std::string_view kFromLayer[] = {"FROM_LAYER"};
    PipelineDesc desc;
    desc.label = "shadow.tile";
    desc.vertexShader = "passes/shadow/shadow_tile.vert";
    desc.fragmentShader = "passes/shadow/shadow_tile.frag";
    desc.depthWrite = true;
    auto clear = device_.createPipeline(desc);
    if (!clear) return tl::unexpected(clear.error());
    desc.defines = kFromLayer;
    auto copy = device_.createPipeline(desc);
    if (!copy) return tl::unexpected(copy.error());
    clear_ = *clear;
    copy_ = *copy;
    return {};
}

void ShadowAtlasPass::recordLayer(const Payload& p, CommandBuffer& commands) {
    commands.push(SetPipeline{p.clear});
    for (const ShadowDraw& draw : p.draws) {
        if (!draw.layerCasters) continue;
        enter(draw, commands);
        commands.push(Draw{3, 1, 0});
    }
    for (const ShadowDraw& draw : p.draws) {
        if (!draw.layerCasters) continue;
        enter(draw, commands);
        commands.push(BindUniforms{RL_UNIFORMS_VIEW, 0, draw.viewUniforms});
        p.binder.record(commands, *draw.layerCasters);
    }
}

void ShadowAtlasPass::recordAtlas(const Payload& p, CommandBuffer& commands) {
    for (const bool copies : {false, true}) {
        bool first = true;
        for (const ShadowDraw& draw : p.draws) {
            if (draw.fromLayer != copies) continue;
            if (std::exchange(first, false)) commands.push(SetPipeline{copies ? p.copy : p.clear});
            enter(draw, commands);
            commands.push(Draw{3, 1, 0});
        }
    }
    for (const ShadowDraw& draw : p.draws) {
        if (!draw.still && !draw.moving) continue;
        enter(draw, commands);
        commands.push(BindUniforms{RL_UNIFORMS_VIEW, 0, draw.viewUniforms});
        if (draw.still) p.binder.record(commands, *draw.still);
        if (draw.moving) p.binder.record(commands, *draw.moving);
    }
}

Result<ShadowAtlasPass::Outputs> ShadowAtlasPass::add(FramePlan& plan, const Inputs& in) {
    const bool usesLayer = std::ranges::any_of(in.draws, &ShadowDraw::fromLayer);
    const bool drawsLayer = std::ranges::any_of(
        in.draws, [](const ShadowDraw& draw) { return draw.layerCasters != nullptr; });
    if (auto ok = createPipelines(); !ok) return tl::unexpected(ok.error());
    if (auto ok = pipelines_.prepare(*in.worlds, casterFlags); !ok)
        return tl::unexpected(ok.error());
    for (const ShadowDraw& draw : in.draws)
        for (DrawList* list : {draw.layerCasters, draw.still, draw.moving})
            if (list)
                if (auto ok = pipelines_.assign(*list); !ok) return tl::unexpected(ok.error());

    const auto import = [&](const char* name, uint32_t& generation) -> Result<ImageId> {
        const PlanImage shape{name, Format::depth32f, in.size, in.size, 1, true};
        const auto kept = in.images->get(shape);
        if (!kept) return tl::unexpected(kept.error());
        generation = kept->generation;
        return plan.importImage(shape, kept->texture);
    };
    // What no tile covers is written once, so that a map's hash is of known bytes.
    const auto loadOp = [](uint32_t& drawn, uint32_t generation) {
        return std::exchange(drawn, generation) == generation ? LoadOp::keep : LoadOp::clear;
    };
    uint32_t generation = 0;
    const auto atlas = import(AtlasGenerations::kAtlas, generation);
    if (!atlas) return tl::unexpected(atlas.error());
    const Payload payload{in.draws, in.binder, clear_, copy_};
    ImageId still;
    if (usesLayer) {
        uint32_t ofLayer = 0;
        const auto layer = import(AtlasGenerations::kStill, ofLayer);
        if (!layer) return tl::unexpected(layer.error());
        still = *layer;
        if (drawsLayer) {
            PassBuilder pass = plan.addPass("shadow.still");
            pass.depth(still, loadOp(in.history->still, ofLayer));
            bindMaterials(pass, in.binder);
            pass.record<Payload>(payload, recordLayer);
        }
    }
    if (!in.draws.empty()) {
        PassBuilder pass = plan.addPass("shadow.atlas");
        pass.depth(*atlas, loadOp(in.history->atlas, generation));
        pass.sample(RL_TEXTURE_SOURCE0, still, nearest_);
        bindMaterials(pass, in.binder);
        pass.record<Payload>(payload, recordAtlas);
    }
    return Outputs{*atlas};
}

}  // namespace rushlight

#include "renderer/passes/shadow/shadow_atlas_pass.h"

#include "renderer/passes/fullscreen.h"
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

void bindMaterials(const DrawBinder& binder, CommandBuffer& commands) {
    commands.push(
        BindTexelBuffer{RL_TEXTURE_MATERIALS, Format::rgba32ui, {}, binder.materials->buffer()});
}

}  // namespace

ShadowAtlasPass::ShadowAtlasPass(Device& device)
    : device_(device),
      pipelines_(device, {.label = "shadow.atlas",
                          .vertexShader = "passes/surface/surface.vert",
                          .fragmentShader = "passes/shadow/depth.frag"}),
      nearest_(nearestClampSampler(device)) {}

ShadowAtlasPass::~ShadowAtlasPass() {
    if (atlas_) device_.destroy(atlas_);
    if (layer_) device_.destroy(layer_);
}

Result<TextureHandle> ShadowAtlasPass::createMap(const char* label, uint32_t size) {
    TextureDesc desc;
    desc.label = label;
    desc.kind = TextureKind::texture2dArray;
    desc.format = Format::depth32f;
    desc.width = desc.height = size;
    return device_.createTexture(desc);
}

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

Result<void> ShadowAtlasPass::prepare(uint32_t size, bool needsLayer) {
    if (auto ok = createPipelines(); !ok) return ok;
    if (size != size_) {
        for (TextureHandle* map : {&atlas_, &layer_})
            if (*map) device_.destroy(std::exchange(*map, {}));
        size_ = size;
    }
    const auto need = [&](TextureHandle& map, bool& isNew, const char* label) -> Result<void> {
        if (map) return {};
        auto texture = createMap(label, size);
        if (!texture) return tl::unexpected(texture.error());
        map = *texture;
        isNew = true;
        return {};
    };
    if (auto ok = need(atlas_, atlasIsNew_, "shadow-atlas"); !ok) return ok;
    return needsLayer ? need(layer_, layerIsNew_, "shadow-atlas-still") : Result<void>();
}

void ShadowAtlasPass::recordLayer(const Payload& p, PassContext& context) {
    CommandBuffer& commands = context.commands;
    commands.push(SetPipeline{p.clear});
    for (const ShadowDraw& draw : p.draws) {
        if (!draw.layerCasters) continue;
        enter(draw, commands);
        commands.push(Draw{3, 1, 0});
    }
    bindMaterials(p.binder, commands);
    for (const ShadowDraw& draw : p.draws) {
        if (!draw.layerCasters) continue;
        enter(draw, commands);
        commands.push(BindUniforms{RL_UNIFORMS_VIEW, 0, draw.viewUniforms});
        p.binder.record(commands, *draw.layerCasters);
    }
}

void ShadowAtlasPass::recordAtlas(const Payload& p, PassContext& context) {
    CommandBuffer& commands = context.commands;
    for (const bool copies : {false, true}) {
        bool first = true;
        for (const ShadowDraw& draw : p.draws) {
            if (draw.fromLayer != copies) continue;
            if (std::exchange(first, false)) {
                commands.push(SetPipeline{copies ? p.copy : p.clear});
                if (copies)
                    commands.push(
                        BindTexture{RL_TEXTURE_SOURCE0, context.texture(p.layer), p.nearest});
            }
            enter(draw, commands);
            commands.push(Draw{3, 1, 0});
        }
    }
    bindMaterials(p.binder, commands);
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
    if (auto ok = prepare(in.size, usesLayer); !ok) return tl::unexpected(ok.error());
    for (const ShadowDraw& draw : in.draws)
        for (DrawList* list : {draw.layerCasters, draw.still, draw.moving})
            if (list)
                if (auto ok = pipelines_.assign(*list); !ok) return tl::unexpected(ok.error());

    Outputs out;
    out.atlas = plan.importImage({"shadow-atlas", Format::depth32f, in.size, in.size}, atlas_);
    Payload payload{in.draws, in.binder, clear_, copy_, {}, nearest_};
    // What no tile covers is written once, so that a map's hash is of known bytes.
    const auto loadOp = [](bool& isNew) {
        return std::exchange(isNew, false) ? LoadOp::clear : LoadOp::keep;
    };
    if (usesLayer)
        payload.layer = plan.importImage({"shadow-atlas-still", Format::depth32f, in.size, in.size},
                                         layer_);
    if (drawsLayer) {
        PassTargets targets;
        targets.depth = {payload.layer, loadOp(layerIsNew_)};
        plan.addPass<Payload>("shadow.still", targets, payload, recordLayer);
    }
    if (!in.draws.empty()) {
        const ImageId reads[] = {payload.layer};
        PassTargets targets;
        targets.depth = {out.atlas, loadOp(atlasIsNew_)};
        targets.reads = reads;
        plan.addPass<Payload>("shadow.atlas", targets, payload, recordAtlas);
    }
    return out;
}

}  // namespace rushlight

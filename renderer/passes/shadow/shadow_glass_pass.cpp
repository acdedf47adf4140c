#include "renderer/passes/shadow/shadow_glass_pass.h"

#include "engine/core/hash.h"
#include "renderer/passes/shadow/caster_flags.h"
#include "shaders/interop/bindings.h"

#include <algorithm>
#include <utility>

namespace rushlight {
namespace {

constexpr const char* kPassNames[kMaxSunViews] = {
    "shadow.glass.0", "shadow.glass.1", "shadow.glass.2", "shadow.glass.3", "shadow.glass.4",
    "shadow.glass.5", "shadow.glass.6", "shadow.glass.7", "shadow.glass.8", "shadow.glass.9"};
constexpr vec4 kNothing{1, 1, 1, 0};  // white, infinitely far

// Of a view without such casters too: 0 stands for "nothing known".
uint64_t contentOf(const ShadowGlassPass::SunView& view) {
    if (view.casters->items.empty()) return 1;
    return mixBits(view.opaque + mixBits(view.casters->contentHash())) | 1;
}

SurfacePipelineDesc pipelinesOf(std::string_view label, bool depthClamp) {
    SurfacePipelineDesc desc;
    desc.label = label;
    desc.vertexShader = "passes/surface/surface.vert";
    desc.fragmentShader = "passes/shadow/shadow_glass.frag";
    desc.depthWrite = false;
    desc.depthClamp = depthClamp;
    desc.transmissive = BlendMode::absorbing;
    return desc;
}

}  // namespace

ShadowGlassPass::ShadowGlassPass(Device& device)
    : device_(device),
      sunPipelines_(device, pipelinesOf("shadow.glass", true)),
      atlasPipelines_(device, pipelinesOf("shadow.atlas.glass", false)) {}

Result<ShadowGlassPass::SunOutputs> ShadowGlassPass::addSun(FramePlan& plan, const SunInputs& in) {
    SunOutputs out;
    if (!in.hasGlass) return out;
    const PlanImage shape{"shadow-map-glass", Format::rgba16f,           in.resolution,
                          in.resolution,      uint32_t(in.views.size()), true};
    const auto image = in.images->get(shape);
    if (!image) return tl::unexpected(image.error());
    auto& contents = in.history->of(*image);
    out.glass = plan.importImage(shape, image->texture);
    constexpr std::string_view kParallel[] = {"PARALLEL_LIGHT"};
    if (auto ok = sunPipelines_.prepare(*in.worlds, glassCasterFlags, kParallel); !ok)
        return tl::unexpected(ok.error());
    for (uint32_t i = 0; i < in.views.size(); ++i) {
        const SunView& view = in.views[i];
        const uint64_t content = contentOf(view);
        if (in.caching && contents[i] == content) continue;
        contents[i] = content;
        out.drawnViews |= 1u << i;
        if (auto ok = sunPipelines_.assign(*view.casters, kParallel); !ok)
            return tl::unexpected(ok.error());
        PassBuilder pass = plan.addPass(kPassNames[i]);
        pass.color(out.glass, LoadOp::clear, kNothing, i).depthTest(in.map, i);
        pass.uniforms(RL_UNIFORMS_VIEW, view.uniforms);
        bindMaterials(pass, in.binder);
        pass.record<DrawnList>({view.casters, in.binder}, DrawnList::record);
    }
    return out;
}

Result<void> ShadowGlassPass::createClear() {
    if (clear_) return {};
    PipelineDesc desc;
    desc.label = "shadow.glass.clear";
    desc.vertexShader = "passes/shadow/shadow_tile.vert";
    desc.fragmentShader = "passes/shadow/shadow_glass_clear.frag";
    auto clear = device_.createPipeline(desc);
    if (!clear) return tl::unexpected(clear.error());
    clear_ = *clear;
    return {};
}

void ShadowGlassPass::recordAtlas(const AtlasPayload& p, CommandBuffer& commands) {
    const auto enter = [&](const GlassDraw& draw) {
        const ShadowTile& t = draw.face->tile;
        commands.push(SetViewport{t.x, t.y, t.size, t.size});
        commands.push(SetScissor{t.x, t.y, t.size, t.size});
    };
    commands.push(SetPipeline{p.clear});
    for (const GlassDraw& draw : p.draws) {
        enter(draw);
        commands.push(Draw{3, 1, 0});
    }
    for (const GlassDraw& draw : p.draws) {
        if (!draw.casters) continue;
        enter(draw);
        commands.push(BindUniforms{RL_UNIFORMS_VIEW, 0, draw.viewUniforms});
        p.binder.record(commands, *draw.casters);
    }
}

Result<ImageId> ShadowGlassPass::addAtlas(FramePlan& plan, const AtlasInputs& in) {
    if (auto ok = createClear(); !ok) return tl::unexpected(ok.error());
    if (auto ok = atlasPipelines_.prepare(*in.worlds, glassCasterFlags); !ok)
        return tl::unexpected(ok.error());
    const PlanImage shape{AtlasGenerations::kGlass, Format::rgba16f, in.size, in.size, 1, true};
    const auto image = in.images->get(shape);
    if (!image) return tl::unexpected(image.error());
    const ImageId glass = plan.importImage(shape, image->texture);
    for (const GlassDraw& draw : in.draws)
        if (draw.casters)
            if (auto ok = atlasPipelines_.assign(*draw.casters); !ok)
                return tl::unexpected(ok.error());
    if (in.draws.empty()) return glass;
    // What no tile covers is written once, so that the map's hash is of known bytes.
    const bool isNew = std::exchange(in.history->glass, image->generation) != image->generation;
    const LoadOp load = isNew ? LoadOp::clear : LoadOp::keep;
    PassBuilder pass = plan.addPass("shadow.atlas.glass");
    pass.color(glass, load, kNothing).depthTest(in.atlas);
    bindMaterials(pass, in.binder);
    pass.record<AtlasPayload>({in.draws, in.binder, clear_}, recordAtlas);
    return glass;
}

}  // namespace rushlight

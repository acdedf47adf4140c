#include "renderer/passes/shadow/shadow_pass.h"

#include "engine/core/hash.h"
#include "renderer/passes/shadow/caster_flags.h"
#include "shaders/interop/bindings.h"

#include <cstring>

namespace rushlight {
namespace {

constexpr const char* kPassNames[kMaxSunViews] = {"shadow.0", "shadow.1", "shadow.2", "shadow.3",
                                                  "shadow.4", "shadow.5", "shadow.6", "shadow.7",
                                                  "shadow.8", "shadow.9"};

}  // namespace

// Casters are drawn where they are: what keeps surfaces from shading themselves is at the receivers
// (shaders/common/shadow/shadow_filter.glsl). Depth is clamped so that casters before the view
// still cast.
ShadowPass::ShadowPass(Device& device)
    : pipelines_(device, {.label = "shadow",
                          .vertexShader = "passes/surface/surface.vert",
                          .fragmentShader = "passes/shadow/depth.frag",
                          .depthClamp = true}) {}

Result<ShadowPass::Outputs> ShadowPass::add(FramePlan& plan, const Inputs& inputs) {
    const uint32_t count = uint32_t(inputs.views.size());
    const uint32_t side = inputs.resolution;
    const PlanImage shape{"shadow-map", Format::depth32f, side, side, count, true};
    const auto image = inputs.images->get(shape);
    if (!image) return tl::unexpected(image.error());
    if (auto ok = pipelines_.prepare(*inputs.worlds, casterFlags); !ok)
        return tl::unexpected(ok.error());
    auto& contents = inputs.history->of(*image);
    Outputs out;
    out.map = plan.importImage(shape, image->texture);
    out.contents = contents;
    for (uint32_t i = 0; i < count; ++i) {
        const View& view = inputs.views[i];
        DrawList& casters = *view.casters;
        const uint64_t hash = casters.contentHash() ^ mixBits(inputs.world.value) ^
                              hashBytes(&view.cascade->clipFromWorld, sizeof(mat4), 7);
        if (inputs.caching && hash == contents[i]) {
            ++out.cached;
            continue;
        }
        contents[i] = hash;
        ++out.drawn;
        out.drawnViews |= 1u << i;
        if (auto ok = pipelines_.assign(casters); !ok) return tl::unexpected(ok.error());
        PassBuilder pass = plan.addPass(kPassNames[i]);
        pass.depth(out.map, LoadOp::clear, i);
        pass.uniforms(RL_UNIFORMS_VIEW, view.uniforms);
        bindMaterials(pass, inputs.binder);
        pass.record<DrawnList>({&casters, inputs.binder}, DrawnList::record);
    }
    return out;
}

}  // namespace rushlight

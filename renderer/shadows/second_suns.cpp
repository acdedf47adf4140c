#include "renderer/shadows/second_suns.h"

#include "renderer/shadows/sun_shadow.h"

#include <algorithm>
#include <limits>

namespace rushlight {

std::array<uint8_t, kMaxDirectionalLights> sunOrder(std::span<const DirectionalLight> lights,
                                                    int sun) {
    std::array<uint8_t, kMaxDirectionalLights> order{};
    size_t next = 0;
    for (const bool casting : {true, false})
        for (size_t i = 0; i < lights.size(); ++i)
            if ((sun >= 0 && lights[i].castsShadow) == casting) order[next++] = uint8_t(i);
    return order;
}

void SecondSuns::makeView(const Inputs& in, const ShadowCascades& cascades, uint32_t cascade,
                          ShadowView& view) const {
    view = {};
    view.clipFromWorld = cascades.cascades[cascade].clipFromWorld;
    view.range = std::numeric_limits<float>::infinity();
    view.scale.pixelsPerMetre = 1 / cascades.cascades[cascade].metresPerTexel;
    view.scale.maxError = in.settings->shadowLodTexelError;
    view.scale.minSize = in.settings->smallObjectPixels;
    if (in.settings->frustumCulling) cascades.addVolume(cascade, in.camera->frustum, view.volume);
}

void SecondSuns::plan(const Inputs& in, JobSystem& jobs) {
    suns_ = 0;
    asked_.clear();
    ShadowCascadeDesc desc = in.cascades;
    desc.count = std::min(desc.count, kCascades);
    for (size_t i = size_t(in.sun) + 1; i < in.directional.size(); ++i) {
        const DirectionalLight& light = in.directional[i];
        if (!light.castsShadow) continue;
        desc.lightDirection = glm::normalize(light.direction);
        ShadowCascades& cascades = cascades_[suns_];
        cascades = makeShadowCascades(*in.camera, desc);
        const SunShadow shadow = makeSunShadow(*in.camera, cascades, light.angularRadius);
        GpuSecondSun& gpu = gpu_[suns_];
        std::ranges::copy(shadow.rows, gpu.rows);
        std::copy_n(shadow.cascades, kCascades, gpu.cascades);
        gpu.settings = shadow.settings;
        gpu.softness = shadow.softness;
        gpu.unused = vec4(0);
        for (uint32_t c = 0; c < cascades.count; ++c) {
            ShadowView& view = views_[suns_ * cascades.count + c];
            makeView(in, cascades, c, view);
            asked_.push_back(&view);
        }
        ++suns_;
    }
    if (suns_ == 0) return;
    visibility_.gather({in.worlds, in.geometry, asked_}, jobs);
    jobs.forRanges(viewCount(), 1, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) {
            const auto list = [&](DrawList& out, std::span<const VisibleItem> items) {
                out.items.assign(items.begin(), items.end());
                out.arrange(in.worlds, *in.geometry, {.casters = true});
            };
            list(lists_[i], visibility_.found(i).items);
            list(glass_[i], visibility_.foundGlass(i).items);
        }
    });
}

}  // namespace rushlight

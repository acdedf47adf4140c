#include "renderer/answers/light_shares.h"

#include "interop/tonemap.h"
#include "renderer/lighting/clusters/light_clusters.h"

#include <algorithm>

namespace rushlight {
namespace {

/// One light of a frame, whichever its kind.
struct Place {
    LightKind kind;
    uint32_t index;
};

std::vector<Place> placesOf(const EditableFrame& frame) {
    std::vector<Place> places;
    for (uint32_t i = 0; i < frame.directional.size(); ++i) places.push_back({LightKind::sun, i});
    for (uint32_t i = 0; i < frame.punctual.size(); ++i) places.push_back({LightKind::punctual, i});
    for (uint32_t i = 0; i < frame.area.size(); ++i) places.push_back({LightKind::area, i});
    return places;
}

bool reaches(const EditableFrame& frame, Place light, const vec3& position) {
    const auto within = [&](const auto& l) {
        return glm::length(position - l.position) <= effectiveRange(l) * 1.01f;
    };
    switch (light.kind) {
        case LightKind::sun: return true;
        case LightKind::punctual: return within(frame.punctual[light.index]);
        case LightKind::area: break;
    }
    return within(frame.area[light.index]);
}

bool castsShadow(const EditableFrame& frame, const FrameSettings& settings, Place light) {
    if (!settings.shadows) return false;
    if (light.kind == LightKind::sun) return frame.directional[light.index].castsShadow;
    if (!settings.lightShadows) return false;
    return light.kind == LightKind::punctual ? frame.punctual[light.index].castsShadow
                                             : frame.area[light.index].castsShadow;
}

void lightAlone(const EditableFrame& from, Place light, EditableFrame& frame) {
    frame.darkenLights();
    const uint32_t i = light.index;
    if (light.kind == LightKind::sun) frame.directional[i] = from.directional[i];
    if (light.kind == LightKind::punctual) frame.punctual[i] = from.punctual[i];
    if (light.kind == LightKind::area) frame.area[i] = from.area[i];
}

}  // namespace

Result<void> addLightShares(Shots& shots, const EditableFrame& plain,
                            std::span<PixelExplanation> pixels) {
    const FrameSettings settings = plain.input().settings;
    for (const Place place : placesOf(plain)) {
        std::vector<PixelExplanation*> reached;
        for (PixelExplanation& pixel : pixels)
            if (pixel.surface && reaches(plain, place, pixel.surface->position))
                reached.push_back(&pixel);
        if (reached.empty()) continue;
        EditableFrame frame = plain;
        frame.removeAmbientLight();
        lightAlone(plain, place, frame);
        const auto alone = shots.take(frame.input(), CaptureKind::hdr);
        if (!alone) return tl::unexpected(alone.error());
        const bool shadowed = castsShadow(plain, settings, place);
        frame.settings().shadows = false;
        const auto open = shadowed ? shots.take(frame.input(), CaptureKind::hdr) : alone;
        if (!open) return tl::unexpected(open.error());
        for (PixelExplanation* pixel : reached) {
            LightShare share{place.kind, place.index,
                             colorAt(*alone, pixel->pixel) - pixel->emissive, 1};
            const float all = interop::luminance(colorAt(*open, pixel->pixel) - pixel->emissive);
            if (!(all > 0)) continue;
            share.shadow = std::clamp(interop::luminance(share.radiance) / all, 0.0f, 1.0f);
            pixel->lights.push_back(share);
        }
    }
    for (PixelExplanation& pixel : pixels)
        std::ranges::stable_sort(pixel.lights, std::greater<>{}, [](const LightShare& light) {
            return interop::luminance(light.radiance);
        });
    return {};
}

}  // namespace rushlight

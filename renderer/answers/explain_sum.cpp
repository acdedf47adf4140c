#include "interop/tonemap.h"
#include "renderer/answers/explain.h"

namespace rushlight {
namespace {

// As shaders/passes/post/tonemap.frag.
vec3 toneMapped(ToneMap map, const vec3& color) {
    switch (map) {
        case ToneMap::none: break;
        case ToneMap::neutral: return interop::saturate3(interop::toneMapNeutral(color));
        case ToneMap::agx: return interop::saturate3(interop::toneMapAgx(color));
        case ToneMap::aces: return interop::toneMapAces(color);
    }
    return interop::saturate3(color);
}

}  // namespace

void addUp(PixelExplanation& p, const FrameInput& input, uvec2 size) {
    p.radiance = p.background + p.ambientDiffuse + p.ambientSpecular + p.emissive + p.reflections +
                 p.fog + p.blendedSurfaces + p.bloom;
    for (const LightShare& light : p.lights) p.radiance += light.radiance;

    float exposure = p.exposure;
    if (input.lighting.background == Background::transparent)
        exposure = p.alpha > 0 ? exposure / std::max(p.alpha, 1.0f / 255) : 0;
    p.display = toneMapped(p.toneMap, glm::max(p.radiance * exposure, vec3(0)));
    p.encoded = interop::encodeSrgb(p.display);
    const vec2 place(float(p.pixel.x) + 0.5f, float(size.y - 1 - p.pixel.y) + 0.5f);
    p.dither = input.settings.dither ? interop::dithered(p.encoded, place) - p.encoded : vec3(0);
    p.sum = p.encoded + p.dither + p.antiAliasing;
    p.error = 0;
    for (int c = 0; c < 3; ++c)
        p.error = std::max(p.error, std::abs(p.sum[c] - float(p.shown[size_t(c)]) / 255));
}

}  // namespace rushlight

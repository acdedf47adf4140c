#include "renderer/frame/quality.h"

namespace rushlight {
namespace {

FrameSettings low() {
    FrameSettings s;
    s.shadowCascades = 1;
    s.shadowResolution = 1024;
    s.shadowAtlasSize = 1024;
    s.shadowTileSize = 128;
    s.shadowFilter = ShadowFilter::hard;
    s.bloom = false;
    s.antiAliasing = AntiAliasing::off;
    s.lodPixelError = s.shadowLodTexelError = 1;
    return s;
}

FrameSettings medium() {
    FrameSettings s;
    s.shadowCascades = 2;
    s.shadowResolution = 1024;
    s.shadowAtlasSize = 2048;
    s.shadowTileSize = 512;
    s.ambientOcclusion = AmbientOcclusion::low;
    s.lodPixelError = s.shadowLodTexelError = 0.5f;
    return s;
}

FrameSettings high() {
    FrameSettings s;
    s.ambientOcclusion = AmbientOcclusion::medium;
    return s;
}

FrameSettings ultra() {
    FrameSettings s;
    s.shadowResolution = 4096;
    s.lightShadows = true;
    s.shadowAtlasSize = 8192;
    s.shadowFilter = ShadowFilter::soft;
    s.ambientOcclusion = AmbientOcclusion::high;
    s.reflections = true;
    s.contactShadows = ContactShadows::lights;
    s.lodPixelError = s.shadowLodTexelError = 0.1f;
    return s;
}

}  // namespace

FrameSettings frameSettings(Quality quality) {
    switch (quality) {
        case Quality::low: return low();
        case Quality::medium: return medium();
        case Quality::high: return high();
        case Quality::ultra: return ultra();
    }
    return {};
}

}  // namespace rushlight

#include "renderer/pipeline/debug_views.h"

#include <cstddef>
#include <iterator>

namespace rushlight {

const DebugViewRow& debugViewRow(DebugView view) {
    using enum Presentation;
    // clang-format off
    // Indexed by DebugView.
    static constexpr DebugViewRow kRows[] = {
        {frame,         nullptr,             false},  // none
        {frameAndBoxes, nullptr,             false},  // bounds
        {channel,       nullptr,             false},  // baseColor
        {channel,       nullptr,             false},  // metallic
        {channel,       nullptr,             false},  // roughness
        {channel,       nullptr,             false},  // normal
        {channel,       nullptr,             false},  // emissive
        {channel,       nullptr,             false},  // occlusion
        {channel,       nullptr,             false},  // velocity
        {channel,       "depth",             true},   // depth
        {channel,       nullptr,             false},  // overdraw
        {channel,       nullptr,             false},  // shadow
        {channel,       nullptr,             false},  // clusters
        {channel,       "ambient-occlusion", false},  // ambientOcclusion
        {part,          "untextured",        true},   // untextured
        {part,          "direct",            true},   // direct
        {part,          "ambient",           true},   // ambient
        {factor,        "ambient-share",     true},   // ambientShare
        {part,          "emission",          true},   // emission
        {radiance,      "lighting",          true},   // lighting
        {radiance,      "reflections",       true},   // reflections
        {radiance,      "fog",               true},   // fog
        {radiance,      "forward",           true},   // forward
        {scattered,     "bloom",             true},   // bloom
        {aliased,       nullptr,             false},  // tonemap
    };
    // clang-format on
    static_assert(std::size(kRows) == size_t(DebugView::count));
    return kRows[size_t(view < DebugView::count ? view : DebugView::none)];
}

FrameSettings presentedSettings(const FrameSettings& settings, Presentation presentation) {
    FrameSettings s = settings;
    if (presentation == Presentation::part || presentation == Presentation::factor) s.bloom = false;
    if (presentation == Presentation::aliased) s.antiAliasing = AntiAliasing::off;
    if (presentation == Presentation::factor) {
        s.toneMap = ToneMap::none;
        s.autoExposure = s.useExposureValue = false;
        s.exposureScale = 1;
    }
    return s;
}

}  // namespace rushlight

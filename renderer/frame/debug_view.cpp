#include "renderer/frame/debug_view.h"

#include <cstddef>
#include <iterator>

namespace rushlight {

const char* toText(DebugView image) {
    // Indexed by DebugView.
    constexpr const char* kNames[] = {
        "frame",       "bounds",   "basecolor",     "metallic", "roughness",
        "normal",      "emissive", "occlusion",     "velocity", "depth",
        "overdraw",    "shadow",   "clusters",      "ao",       "untextured",
        "direct",      "ambient",  "ambient-share", "emission", "lighting",
        "reflections", "fog",      "forward",       "bloom",    "tonemap"};
    static_assert(std::size(kNames) == size_t(DebugView::count));
    return image < DebugView::count ? kNames[size_t(image)] : "?";
}

}  // namespace rushlight

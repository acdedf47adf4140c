#include "renderer/frame/frame_input.h"

namespace rushlight {

const char* toText(ShownImage image) {
    // Indexed by ShownImage.
    constexpr const char* kNames[] = {
        "frame",       "bounds",   "basecolor",     "metallic", "roughness",
        "normal",      "emissive", "occlusion",     "velocity", "depth",
        "overdraw",    "shadow",   "clusters",      "ao",       "untextured",
        "direct",      "ambient",  "ambient-share", "emission", "lighting",
        "reflections", "fog",      "forward",       "bloom",    "tonemap"};
    static_assert(std::size(kNames) == size_t(ShownImage::count));
    return image < ShownImage::count ? kNames[size_t(image)] : "?";
}

}  // namespace rushlight

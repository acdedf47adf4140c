#pragma once

#include <cstdint>

namespace rushlight {

/// A picture of what a frame made on its way, shown in place of the frame. In the deck's order.
enum class DebugView : uint8_t {
    none,    ///< the frame
    bounds,  ///< the frame with the visible objects' boxes drawn over it
    baseColor,
    metallic,
    roughness,
    normal,
    emissive,
    occlusion,
    velocity,
    depth,
    overdraw,          ///< how often the G-buffer was written at a pixel
    shadow,            ///< the cascades side by side, and the atlas of point and spot lights
    clusters,          ///< lights per froxel as a heat map
    ambientOcclusion,  ///< of the screen: white where the ambient light is open
    untextured,        ///< HDR: deferred lighting as if all surfaces were white and not metallic
    direct,            ///< HDR: what suns and lamps give, shadowed
    ambient,           ///< HDR: what the surroundings would give if nothing hid them
    ambientShare,      ///< the share of that which arrives, by channel
    emission,  ///< HDR: what glows by itself: emissive and unlit surfaces, and the background
    lighting,  ///< HDR after deferred lighting, before forward: direct + ambient * ambientShare +
               ///< emission
    reflections,  ///< HDR: what surfaces mirror of the screen
    fog,  ///< HDR: the light that the air scatters, before black; alpha is the share that it covers
    forward,  ///< HDR after forward
    bloom,
    tonemap,  ///< before anti-aliasing
    count
};
const char* toText(DebugView image);  ///< the names of `--pass`

}  // namespace rushlight

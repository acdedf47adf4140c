// A texel of the ambient-occlusion image, drawn in interop/occlusion_arc.h.
#include "interop/occlusion_arc.h"

float packOcclusion(float depth, float visible) {
    uint low = uint(clamp(visible, 0.0, 1.0) * 1023.0 + 0.5);
    return uintBitsToFloat((floatBitsToUint(depth) & ~1023u) | low);
}

float occlusionVisible(float texel) {
    return float(floatBitsToUint(texel) & 1023u) * (1.0 / 1023.0);
}

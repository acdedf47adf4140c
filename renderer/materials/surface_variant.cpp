#include "renderer/materials/surface_variant.h"

namespace rushlight {
namespace {

// Indexed by bit.
constexpr std::string_view kDefines[kSurfaceFlagCount] = {
    "BASE_COLOR_TEXTURE",
    "METALLIC_ROUGHNESS_TEXTURE",
    "NORMAL_TEXTURE",
    "OCCLUSION_TEXTURE",
    "EMISSIVE_TEXTURE",
    "EMISSIVE",
    "OCCLUSION_IN_METALLIC_ROUGHNESS",
    "SECOND_UV",
    "UV_TRANSFORMS",
    "ALPHA_MASK",
    "UNLIT",
    "DOUBLE_SIDED",
    "MIRRORED",
    "EXTENDED",
    "MOVING",
    "BLEND",
    "TRANSMISSION",
    "TRANSMISSION_TEXTURE",
};

}  // namespace

void appendDefines(uint32_t surfaceFlags, std::vector<std::string_view>& defines) {
    for (uint32_t bit = 0; bit < kSurfaceFlagCount; ++bit)
        if (surfaceFlags >> bit & 1) defines.push_back(kDefines[bit]);
}

}  // namespace rushlight

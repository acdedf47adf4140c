#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace rushlight {

/// Number of levels down to 1x1.
uint32_t mipLevelCount(uint32_t width, uint32_t height);

/// Level k + 1 from level k of RGBA8 by a 2x2 box (of odd sizes by three texels, each by how much
/// of it is covered); colours are averaged in linear light when `srgb`.
std::vector<uint8_t> halveImage(std::span<const uint8_t> pixels, uint32_t width, uint32_t height,
                                bool srgb);

}  // namespace rushlight

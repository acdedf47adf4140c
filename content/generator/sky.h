#pragma once

#include <cstdint>
#include <vector>

namespace rushlight::content {

/// The dusk sky over the square without its sun, as a Radiance picture of 128 x 64
/// (equirectangular; u = atan2(z, x) / 2 pi
/// + 1/2, v from the zenith). Radiance in the unit of the level's lights.
std::vector<uint8_t> encodeDuskSky();

}  // namespace rushlight::content

#pragma once

#include "interop/ltc.h"

#include <array>

namespace rushlight {

/// Inverse matrices by view and roughness, as interop::ltcCoordinates finds them.
extern const std::array<vec4, RL_LTC_TABLE_SIZE * RL_LTC_TABLE_SIZE> kLtcTable;

/// Bilinear, as a sampler that clamps to the edge.
vec4 lookUpLtc(float nDotV, float roughness);

}  // namespace rushlight

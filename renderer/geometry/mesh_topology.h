#pragma once
// Which vertices of a mesh are in one place, and what follows of it.

#include "engine/core/math.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rushlight {

/// By vertex, a number that those in one place share. One place is what is the same to a millionth
/// of the mesh's size: where a surface of revolution closes, sin 0 is not quite sin 2π.
std::vector<uint32_t> placesOf(std::span<const vec3> positions);

/// True when every directed edge, from place to place, has its opposite.
bool isClosed(std::span<const vec3> positions, std::span<const uint32_t> indices);

}  // namespace rushlight

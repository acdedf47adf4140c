#pragma once
// Half floats (IEEE 754 binary16) of pictures, many at a time.

#include <cstddef>
#include <cstdint>
#include <span>

namespace rushlight {

/// Exact. `halves` is aligned to two bytes and has twice as many as there are floats.
void floatsFromHalves(std::span<const std::byte> halves, std::span<float> floats);

/// False where a float has no equal half; `halves`, as many as floats, then hold anything.
bool exactHalves(std::span<const float> floats, std::span<uint16_t> halves);

}  // namespace rushlight

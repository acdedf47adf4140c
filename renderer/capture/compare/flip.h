#pragma once
// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild, "FLIP: A Difference Evaluator
// for Alternating Images", High-Performance Graphics 2020: how large the difference looks to
// someone who flips between two pictures.

#include "engine/core/math.h"
#include "renderer/capture/compare/separable_filter.h"

#include <span>

namespace rushlight {

/// Of a display of 0.7 m width and 3840 pixels seen from 0.7 m: 0.7 * 3840 / 0.7 * π/180.
inline constexpr float kDefaultPixelsPerDegree = 67.0206f;

/// For every pixel 0 (no difference is seen) to 1. Both pictures: linear Rec.709 from 0 to 1,
/// `width` * `height`.
Plane flipErrors(std::span<const vec3> reference, std::span<const vec3> test, uint32_t width,
                 uint32_t height, float pixelsPerDegree);

}  // namespace rushlight

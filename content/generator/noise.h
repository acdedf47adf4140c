#pragma once
// Noise on the unit torus: every function repeats when u or v grows by 1, so that textures tile.

#include "content/generator/numeric.h"

namespace rushlight::content {

/// Value noise in [0, 1] with `cellsU` x `cellsV` cells over the torus.
float valueNoise(float u, float v, int cellsU, int cellsV, uint32_t seed);

/// A sum of `octaves` value noises, each of twice the cells and half the weight; in [0, 1].
float fractalNoise(float u, float v, int cellsU, int cellsV, int octaves, uint32_t seed);

/// The nearest of one jittered point per cell; odd rows are shifted by half a cell.
struct CellHit {
    uint32_t id = 0;  ///< of the nearest point's cell
    float edge = 0;   ///< distance to the border with the next cell, in cells
    vec2 offset{0};   ///< from the nearest point, in cells
};
CellHit cellNoise(float u, float v, int cellsU, int cellsV, float jitter, uint32_t seed);

}  // namespace rushlight::content

#pragma once
// Which froxels a light reaches: spheres and cones against pieces of the view volume, by SIMD that
// is chosen at run time (Highway). Everything is in view space with the depth as z: x to the right,
// y up, z ahead.

#include "engine/core/math.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rushlight {

/// The grid of froxels. A tile's edges are at slope * (depth, or 1 for an orthographic view).
struct FroxelGrid {
    bool perspective = true;
    uint32_t tilesX = 1, tilesY = 1, slices = 1;
    /// Edges of the tiles: one more than there are tiles, then padding for whole vectors.
    std::vector<float> slopesX, slopesY;
    std::vector<float> rootsX, rootsY;         ///< 1 / sqrt(1 + slope²) of each edge
    std::vector<float> depths;                 ///< edges of the slices
    float inverseTileX = 1, inverseTileY = 1;  ///< tiles in a slope of 1
    float tileRadius = 0;                      ///< half of a tile's diagonal, in slopes

    void setTiles(float slopeLimitX, float slopeLimitY, float tileSlopeX, float tileSlopeY);
};

/// The part of space that a light reaches: a sphere, and of it what lies within a cone.
struct LightVolume {
    vec3 center{0};
    float radius = 0;
    vec3 apex{0};
    vec3 axis{0};       ///< unit
    float cosine = -1;  ///< of the cone's half angle; < 0: no cone
    uint16_t slot = 0;
    uint8_t lightClass = 0;
};

struct LightVolumes {
    std::vector<LightVolume> items;
    std::vector<float> nearest, farthest;  ///< depths, padded for whole vectors

    void clear() { items.clear(); }
    void finish();  ///< after the last item
};

inline constexpr uint32_t kLightClasses = 3;

/// Rows of tiles in one slice: what one job does.
struct FroxelBand {
    uint32_t slice, firstRow, lastRow;
};

/// Adds to counts[froxel * lists + class] the lights that may reach into it (never missing one that
/// does).
void countLights(const FroxelGrid&, const LightVolumes&, const FroxelBand&, uint32_t lists,
                 uint32_t* counts);

/// As it counted, writes the slots at next[froxel * lists + class] until it is at its end, in the
/// order of the volumes.
void writeLights(const FroxelGrid&, const LightVolumes&, const FroxelBand&, uint32_t lists,
                 uint32_t* next, const uint32_t* ends, uint16_t* slots);

}  // namespace rushlight

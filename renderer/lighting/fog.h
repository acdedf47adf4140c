#pragma once
// A medium that fills the world: it takes light away and scatters that of suns, lamps and
// surroundings towards the eye.

#include "engine/core/math.h"
#include "renderer/frame/lights.h"
#include "renderer/geometry/view_math.h"
#include "shaders/interop/frame_uniforms.h"

namespace rushlight {

/// The froxels in which light is gathered: tiles of pixels times slices of view depth. On the GPU
/// the slices lie side by side in one image, kColumns in a row:
///
///     [ 0 ][ 1 ] ... [ 7 ]      y = 0
///     [ 8 ][ 9 ] ... [ 15]
struct FogGrid {
    static constexpr uint32_t kTilePixels = RL_FOG_PIXELS;
    static constexpr uint32_t kSlices = RL_FOG_SLICES;
    static constexpr uint32_t kColumns = RL_FOG_COLUMNS;

    uint32_t width = 1, height = 1;  ///< pixels of the target
    uint32_t tilesX = 1, tilesY = 1;
    float nearest = 0, farthest = 0;  ///< view depths, metres; slice 0 begins at the eye and ends
                                      ///< at `nearest`

    uint32_t imageWidth() const { return tilesX * kColumns; }
    uint32_t imageHeight() const { return tilesY * (kSlices / kColumns); }
};

FogGrid makeFogGrid(const Fog& fog, const CameraMatrices& camera, uint32_t width, uint32_t height);

/// The fog's part of the uniforms.
void fillFog(const Fog& fog, const FogGrid& grid, const CameraMatrices& camera,
             interop::LightingUniforms& uniforms);

}  // namespace rushlight

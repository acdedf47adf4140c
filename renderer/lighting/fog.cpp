#include "renderer/lighting/fog.h"

#include <algorithm>
#include <cmath>

namespace rushlight {

FogGrid makeFogGrid(const Fog& fog, const CameraMatrices& camera, uint32_t width, uint32_t height) {
    FogGrid grid;
    grid.width = width;
    grid.height = height;
    grid.tilesX = (width + FogGrid::kTilePixels - 1) / FogGrid::kTilePixels;
    grid.tilesY = (height + FogGrid::kTilePixels - 1) / FogGrid::kTilePixels;
    grid.farthest = fog.litDistance;
    // 63 slices over a ratio of 200 are 9 % deep each.
    grid.nearest = std::max(camera.nearPlane, grid.farthest / 200);
    grid.farthest = std::max(grid.farthest, grid.nearest * 1.01f);
    return grid;
}

void fillFog(const Fog& fog, const FogGrid& grid, const CameraMatrices& camera,
             interop::LightingUniforms& u) {
    // No more than e^80: a camera far below the fog's height must not make it infinite.
    const float exponent = -fog.heightFalloff * (camera.position.y - fog.height);
    const float here = fog.density * std::exp(std::min(exponent, 80.0f));
    u.fogMedium = {here, fog.heightFalloff, fog.anisotropy, 0};
    u.fogAlbedo = vec4(fog.albedo, 0);
    const float scale = float(FogGrid::kSlices - 1) / std::log2(grid.farthest / grid.nearest);
    u.fogMapping = {scale, 1 - std::log2(grid.nearest) * scale, grid.nearest, grid.farthest};
    u.fogGrid = {float(grid.tilesX), float(grid.tilesY), 1 / float(grid.width),
                 1 / float(grid.height)};
}

}  // namespace rushlight

#pragma once
// Where a probe can be, and how far it sees.

#include "renderer/lighting/irradiance_volume.h"
#include "renderer/raytrace/ray_scene.h"

namespace rushlight {

struct ProbePlace {
    vec3 offset{0};     ///< metres from its place in the grid, within 0.45 of a cell
    bool open = false;  ///< false: it is inside something
};

/// A probe that mostly sees backs of surfaces is inside something and goes out by the nearest one;
/// one that is close to a surface steps back from it. Majercik et al. 2021, "Scaling Probe-Based
/// Real-Time Dynamic Global Illumination for Production", JCGT 10(2), section 4.
ProbePlace findProbePlace(const RayScene& scene, const ProbeGrid& grid, uint32_t probe);

/// Fills the probe's distances, at most half again a cell's diagonal each.
void measureDistances(const RayScene& scene, IrradianceVolume& volume, uint32_t probe,
                      const vec3& position);

}  // namespace rushlight

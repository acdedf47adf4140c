#pragma once
// Light along a ray, by paths. Bounces are diffuse with the surface's whole albedo, diffuse and
// specular, from the shared BRDF (environmentWeights): for light that is gathered over a hemisphere
// anyway.

#include "renderer/lighting/brdf_table.h"
#include "renderer/lighting/irradiance_volume.h"
#include "renderer/raytrace/bake_light.h"
#include "renderer/raytrace/ray_scene.h"

namespace rushlight {

class PathTracer {
public:
    /// All must outlive it. `bounces`: at most so many after the first surface.
    /// `known`: where it covers the first surface, its light is taken instead of bouncing on; null:
    /// none.
    PathTracer(const RayScene& scene, const BakeLight& light, const BrdfTable& table,
               uint32_t bounces, const IrradianceVolume* known = nullptr)
        : scene_(scene), light_(light), table_(table), bounces_(bounces), known_(known) {}

    /// Radiance that arrives at `origin` from `direction` (unit). `density` is that with which the
    /// direction was drawn where sampleSky() was drawn from as well, per steradian and times the
    /// number of samples each: light of the sky is weighted by the balance heuristic (Veach 1997,
    /// section 9.2.2). Infinite: the sky counts in full.
    vec3 radiance(const vec3& origin, const vec3& direction, float density, float skySamples,
                  RayRandom& random) const;

    const BakeLight& light() const { return light_; }
    const RayScene& scene() const { return scene_; }

private:
    struct Surface;
    vec3 lampLight(const Surface& surface, RayRandom& random) const;
    vec3 punctualLight(const Surface& surface, RayRandom& random) const;
    vec3 areaLight(const Surface& surface, RayRandom& random) const;
    vec3 glow(const RaySurface& surface, const vec3& position, const vec3& direction) const;
    vec3 skyLight(const Surface& surface, RayRandom& random) const;

    const RayScene& scene_;
    const BakeLight& light_;
    const BrdfTable& table_;
    uint32_t bounces_;
    const IrradianceVolume* known_;
};

}  // namespace rushlight

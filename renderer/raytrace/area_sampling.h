#pragma once
// Area lights as paths look for them: points of their surface, drawn from where they are looked
// for.

#include "renderer/frame/lights.h"
#include "renderer/raytrace/ray_random.h"

namespace rushlight {

/// A point of an area light's surface, seen from where it was drawn for.
struct AreaSample {
    vec3 direction{0};   ///< unit, towards it
    float distance = 0;  ///< metres to it, as far as things cast shadows: up to
                         ///< AreaLight::shadowNear before it
    /// Luminance within AreaLight::range over the density per steradian with which the direction
    /// was drawn: its mean times the cosine is irradiance. 0: the point does not shine here.
    vec3 light{0};
};

/// Spheres evenly by solid angle, the others evenly by area, of a tube the part that may be seen:
/// nothing is looked for in between. Nothing from within a sphere or tube. Takes the same count of
/// random numbers whatever is found.
AreaSample sampleAreaLight(const AreaLight& light, const vec3& position, RayRandom& random);

/// Is what glows at `position`, seen along `direction` (unit), what stands for the light: nearer to
/// its surface than AreaLight::shadowNear, on a side that shines?
bool standsFor(const AreaLight& light, const vec3& position, const vec3& direction);

}  // namespace rushlight

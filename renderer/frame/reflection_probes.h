#pragma once
// Light captured within the scene, for what is around there: mirrored as in a box, and scattered.

#include "engine/core/result.h"
#include "renderer/frame/resource_descs.h"

namespace rushlight {

/// A box and the environment that is seen from a place within it (Renderer::captureEnvironment, or
/// any other). Surfaces in the box mirror that environment as if it stood on the box's sides; where
/// the frame has no irradiance volume they are also lit by it, in place of the unhidden
/// surroundings. Where boxes overlap, the smaller one counts.
struct ReflectionProbe {
    vec3 position{0};  ///< where the environment is seen from, world; within the box
    EnvironmentHandle environment;
    vec3 center{0};             ///< of the box, world
    vec3 halfSize{1};           ///< metres along the box's own axes; over 0
    quat rotation{1, 0, 0, 0};  ///< of the box; the environment is not turned by it
    /// Metres within the box's sides over which the probe's influence rises from none to all, along
    /// each axis. 0: at the side, as for the walls of a room, and what lies on them is within.
    vec3 blend{0};
    float intensity = 1;  ///< factor on the environment's radiance; not negative
};

/// What Renderer::captureEnvironment sees.
struct CaptureDesc {
    uint32_t size = 256;  ///< pixels along a face: 16, 32, ... 1,024. Reflections hold 256 of them
    float nearPlane = 0.05f;  ///< metres, over 0
    float farPlane = 0;       ///< metres; 0: infinite
};

/// In Lighting::reflectionProbes.
inline constexpr uint32_t kMaxReflectionProbes = 256;
/// What one frame shows of them: those whose boxes are in view, nearest to the eye first.
inline constexpr uint32_t kMaxShownReflectionProbes = 16;

/// An Error that names the probe by its index, but for its environment, which is not looked at.
Result<void> checkReflectionProbes(std::span<const ReflectionProbe> probes);
Result<void> checkCapture(const vec3& position, const CaptureDesc& desc);

}  // namespace rushlight

#pragma once
// The light of one frame. Radiometric units are photometric ones times a colour; linear Rec.709.

#include "renderer/frame/light_patterns.h"
#include "renderer/frame/reflection_probes.h"
#include "renderer/frame/resource_descs.h"

namespace rushlight {

struct DirectionalLight {
    vec3 direction{0, -1, 0};        ///< unit, world space, the way the light travels
    vec3 illuminance{1};             ///< lux times colour
    bool castsShadow = true;         ///< in frames; in baked light all lights do
    float angularRadius = 0.00465f;  ///< radians, half of what its disk spans, for soft shadows;
                                     ///< the sun's
};

/// Point and spot lights. Attenuation as KHR_lights_punctual: max(min(1-(d/range)^4, 1), 0) / d².
struct PunctualLight {
    vec3 position{0};
    vec3 intensity{1};          ///< candela times colour
    float range = 0;            ///< metres; 0: unbounded
    vec3 direction{0, -1, 0};   ///< unit, world space, the way a spot shines; the axis of `profile`
                                ///< and `cookie`
    float innerConeAngle = 0;   ///< radians from the axis
    float outerConeAngle = -1;  ///< < 0: a point light
    bool castsShadow = false;
    float radius = 0;          ///< metres, of the source, for soft shadows; 0: a point
    float shadowNear = 0.05f;  ///< metres; what is nearer to the light casts no shadow: its own
                               ///< bulb or housing
    LightProfileHandle profile = {};  ///< null: as bright in all directions; `intensity` is that of
                                      ///< its brightest
    LightCookieHandle cookie = {};    ///< null: none
    vec3 up{0, 0, -1};  ///< for the roll of those two; any length, best at right angles to
                        ///< `direction`
};

enum class AreaShape : uint8_t { rectangle, disk, sphere, tube };

/// A surface of the same luminance everywhere and in all directions. It lights surfaces and is not
/// itself drawn: give what stands for it an emissive material. Its power is pi * luminance * area
/// lumens a side.
struct AreaLight {
    AreaShape shape = AreaShape::rectangle;
    vec3 position{0};  ///< of its middle
    /// Metres from the middle: to two neighbouring sides of a rectangle, or along two half axes of
    /// a disk, at right angles to each other. The front looks along cross(halfX, halfY). A tube
    /// reaches from -halfX to +halfX.
    vec3 halfX{0.5f, 0, 0};
    vec3 halfY{0, 0.5f, 0};
    float radius = 0.1f;    ///< metres, of a sphere or a tube
    vec3 luminance{1000};   ///< candela per square metre times colour
    bool twoSided = false;  ///< a rectangle or disk that shines backwards too
    /// Metres from the middle beyond which it lights nothing, with the window of
    /// KHR_lights_punctual; 0: unbounded.
    float range = 0;
    /// What hides its middle casts a shadow; with soft shadows, what hides a part of it takes that
    /// part away.
    bool castsShadow = false;
    float shadowNear = 0.02f;  ///< metres; what is nearer to its surface casts no shadow: what
                               ///< stands for it, its frame
};

enum class Background : uint8_t { color, environment, transparent };

/// The sun, seen: drawn over an environment that is shown as the background. It lights nothing.
struct SunDisk {
    vec3 direction{0, 1, 0};   ///< unit, world space, towards it
    float radius = 0.004675f;  ///< radians
    vec3 radiance{0};          ///< black: there is none
};

/// Air that scatters: exponential height fog, lit by the suns and the clustered lights with their
/// shadows and by the ambient light. It covers what lies behind it, the background included.
struct Fog {
    float density = 0;        ///< extinction per metre at `height`; 0: there is none
    float heightFalloff = 0;  ///< per metre: extinction is density * exp(-heightFalloff * (y -
                              ///< height)); 0: the same everywhere
    float height = 0;         ///< metres, world y
    vec3 albedo{0.95f};       ///< scattered share of what is taken away, [0, 1]
    float anisotropy = 0.3f;  ///< Henyey and Greenstein's g, -0.95 to 0.95: > 0 scatters forwards
    float litDistance = 80;   ///< metres from the eye within which light and shadow are gathered;
                              ///< beyond, the farthest go on
};

struct Lighting {
    std::span<const DirectionalLight> directional;  ///< at most kMaxDirectionalLights; the first
                                                    ///< that casts has the finest shadows
    std::span<const PunctualLight> punctual;        ///< at most kMaxPunctualLights
    std::span<const AreaLight> area;                ///< at most kMaxAreaLights
    EnvironmentHandle environment;                  ///< zero: the hemisphere ambient below
    float environmentRotation = 0;                  ///< radians about +y
    float environmentIntensity = 1;
    vec3 ambientSky{0};     ///< irradiance/π from above, used when there is no environment
    vec3 ambientGround{0};  ///< from below
    /// Indirect light and the sky as seen from within the scene, in place of the unhidden
    /// environment or hemisphere, which begin a cell beyond it. To be baked under the same lights
    /// and environment as are given here.
    IrradianceVolumeHandle irradianceVolume;
    std::span<const ReflectionProbe> reflectionProbes;  ///< at most kMaxReflectionProbes
    Background background = Background::color;
    vec3 backgroundColor{0};  ///< linear radiance; not tone mapped to anything else than the
                              ///< surfaces are
    SunDisk sunDisk;
    Fog fog;
};

inline constexpr uint32_t kMaxDirectionalLights = 4;
inline constexpr uint32_t kMaxPunctualLights = 4096;
inline constexpr uint32_t kMaxAreaLights = 1024;

}  // namespace rushlight

#include "renderer/pipeline/stages/lighting_uniforms.h"

#include "interop/irradiance_volume.h"
#include "renderer/shadows/second_suns.h"

#include <cmath>

namespace rushlight {

interop::ViewUniforms makeViewUniforms(const CameraMatrices& camera) {
    interop::ViewUniforms u{};
    u.clipFromWorld = camera.clipFromWorld;
    u.previousClipFromWorld = camera.previousClipFromWorld;
    u.cameraPosition = vec4(camera.position, camera.perspective ? 1 : 0);
    u.cameraForward = vec4(camera.forward, 0);
    return u;
}

namespace {

void fillRays(const CameraMatrices& camera, interop::LightingUniforms& u) {
    const float x = camera.perspective ? camera.tanHalfX : camera.halfWidth;
    const float y = camera.perspective ? camera.tanHalfY : camera.halfHeight;
    const vec2 low = camera.center - vec2(x, y);
    const vec4 corner = vec4(camera.right * low.x + camera.up * low.y, 0);
    const vec4 right = vec4(camera.right * (2 * x), 0), up = vec4(camera.up * (2 * y), 0);
    if (camera.perspective) {
        u.rayCorner = corner + vec4(camera.forward, 0);
        u.rayRight = right;
        u.rayUp = up;
    } else {
        u.rayCorner = vec4(camera.forward, 0);
        u.baseCorner = corner;
        u.baseRight = right;
        u.baseUp = up;
    }
    u.depthDecode = vec4(camera.depthDecode, 0, 0);
    u.viewDirection = vec4(camera.forward, 0);
}

}  // namespace

namespace {

void fillShadows(const SunShadow& shadow, interop::LightingUniforms& u) {
    for (int i = 0; i < 3; ++i) u.shadowRows[i] = shadow.rows[i];
    for (int i = 0; i < 4; ++i) u.shadowCascades[i] = shadow.cascades[i];
    u.shadowSettings = shadow.settings;
    u.shadowSoftness = shadow.softness;
}

// What is around the probes: the environment, turned as it is, or the hemisphere.
vec4 outerBand(const Lighting& lighting, const GpuEnvironment* environment, int color) {
    if (!environment) {
        const float sky = lighting.ambientSky[color], ground = lighting.ambientGround[color];
        return {0.5f * (sky + ground), 0, 0.25f * (sky - ground), 0};
    }
    const float c = std::cos(lighting.environmentRotation);
    const float s = std::sin(lighting.environmentRotation);
    const vec4 band = environment->bands[size_t(color)] * lighting.environmentIntensity;
    return {band.x, c * band.y + s * band.w, band.z, c * band.w - s * band.y};
}

void fillVolume(const CameraMatrices& camera, const Lighting& lighting,
                const GpuIrradianceVolume& volume, const GpuEnvironment* environment,
                interop::LightingUniforms& u) {
    const ProbeGrid& grid = volume.grid;
    u.volumeOrigin = vec4(grid.origin - camera.position,
                          interop::kProbeNormalBias * grid.smallestSpacing());
    u.volumeScale = vec4(1.0f / grid.spacing, 0);
    u.volumeLast = vec4(vec3(grid.counts) - 1.0f, 0);
    constexpr float kLuminance[3] = {0.2126f, 0.7152f, 0.0722f};
    vec4 luminous(0);
    for (int i = 0; i < 3; ++i) {
        u.volumeOuter[i] = outerBand(lighting, environment, i);
        luminous += kLuminance[i] * u.volumeOuter[i];
    }
    u.volumeOuterLuminance = luminous.x > 0
                                 ? vec4(luminous.x,
                                        vec3(luminous.y, luminous.z, luminous.w) / luminous.x)
                                 : vec4(0);
}

}  // namespace

interop::LightingUniforms makeLightingUniforms(const CameraMatrices& camera,
                                               const Lighting& lighting, int sun,
                                               const LightClusters& clusters,
                                               const ShadowCascades& cascades,
                                               const GpuEnvironment* environment,
                                               const GpuIrradianceVolume* volume) {
    interop::LightingUniforms u{};
    fillRays(camera, u);
    u.clusterMapping = clusters.mapping();
    u.clusterCounts = clusters.counts();
    if (cascades.count > 0)
        fillShadows(
            makeSunShadow(camera, cascades, lighting.directional[size_t(sun)].angularRadius), u);

    const size_t count = lighting.directional.size();
    const auto order = sunOrder(lighting.directional, sun);
    for (size_t i = 0; i < count; ++i) {
        const DirectionalLight& light = lighting.directional[order[i]];
        u.directionalDirections[i] = vec4(-glm::normalize(light.direction), 0);
        u.directionalIlluminances[i] = vec4(light.illuminance, 0);
    }
    if (environment) {
        u.environment = {std::cos(lighting.environmentRotation),
                         std::sin(lighting.environmentRotation), lighting.environmentIntensity,
                         float(kEnvironmentLevels)};
    }
    u.ambientSky = vec4(lighting.ambientSky, 0);
    u.ambientGround = vec4(lighting.ambientGround, 0);
    if (volume) fillVolume(camera, lighting, *volume, environment, u);
    u.background = lighting.background == Background::transparent
                       ? vec4(0)
                       : vec4(lighting.backgroundColor, 1);
    const SunDisk& disk = lighting.sunDisk;
    u.sunDisk = vec4(glm::normalize(disk.direction), std::cos(disk.radius));
    u.sunDiskRadiance = vec4(disk.radiance, 0);
    return u;
}

}  // namespace rushlight

#include "renderer/pipeline/frame_checks.h"

#include <cmath>
#include <utility>

namespace rushlight {
namespace {

constexpr uint32_t kMaxSide = 16384;

Result<void> checkAreaLights(std::span<const AreaLight> lights) {
    const auto wrong = [](size_t index, const char* what) {
        return fail("area light " + std::to_string(index), what, ErrorKind::wrongUse);
    };
    if (lights.size() > kMaxAreaLights)
        return fail("lighting",
                    "there are " + std::to_string(lights.size()) +
                        " area lights; at most 1,024 are possible.",
                    ErrorKind::wrongUse);
    for (size_t i = 0; i < lights.size(); ++i) {
        const AreaLight& light = lights[i];
        const float x = glm::length(light.halfX), y = glm::length(light.halfY);
        if (!std::isfinite(glm::length(light.position) + x + y + light.radius + light.range +
                           light.shadowNear + glm::length(light.luminance)))
            return wrong(i, "a part of it is not finite.");
        const bool flat = light.shape == AreaShape::rectangle || light.shape == AreaShape::disk;
        if (flat && !(glm::length(glm::cross(light.halfX, light.halfY)) > 1e-3f * x * y))
            return wrong(i,
                         "its half axes span no area; they must be at right angles to each other.");
        if (!flat && !(light.radius > 0)) return wrong(i, "its radius is not above 0.");
        if (light.shape == AreaShape::tube && !(x > 0)) return wrong(i, "its tube has no length.");
        if (light.range < 0) return wrong(i, "its range is negative.");
    }
    return {};
}

Result<void> checkPatterns(std::span<const PunctualLight> lights,
                           const LightPatternStore& lightPatterns) {
    const auto wrong = [](size_t index, const char* what) {
        return fail("point or spot light " + std::to_string(index), what, ErrorKind::wrongUse);
    };
    for (size_t i = 0; i < lights.size(); ++i) {
        const PunctualLight& light = lights[i];
        if (!light.profile && !light.cookie) continue;
        if (light.profile && !lightPatterns.find(light.profile))
            return wrong(i, "its profile is a stale handle.");
        if (light.cookie && !lightPatterns.find(light.cookie))
            return wrong(i, "its cookie is a stale handle.");
        if (!std::isfinite(glm::length(light.up))) return wrong(i, "its up vector is not finite.");
    }
    return {};
}

}  // namespace

Result<void> checkFrame(const FrameInput& input, const FrameTarget& target, const Stores& stores) {
    const auto wrong = [](const char* object, const std::string& what) {
        return fail(object, what, ErrorKind::wrongUse);
    };
    const uint32_t w = target.width, h = target.height;
    if (w == 0 || h == 0 || w > kMaxSide || h > kMaxSide)
        return wrong("frame target", "its size is " + std::to_string(w) + "x" + std::to_string(h) +
                                         "; each side must be 1 to 16,384 pixels.");
    const Lighting& lighting = input.lighting;
    if (lighting.directional.size() > kMaxDirectionalLights)
        return wrong("lighting", "there are " + std::to_string(lighting.directional.size()) +
                                     " directional lights; at most 4 are possible.");
    if (lighting.punctual.size() > kMaxPunctualLights)
        return wrong("lighting", "there are " + std::to_string(lighting.punctual.size()) +
                                     " point and spot lights; at most 4,096 are possible.");
    for (const DirectionalLight& light : lighting.directional)
        if (const float length = glm::length(light.direction);
            !(length > 0) || !std::isfinite(length) ||
            !std::isfinite(glm::length(light.illuminance)))
            return wrong("lighting", "a directional light is not finite or has no direction.");
    for (const PunctualLight& light : lighting.punctual)
        if (!std::isfinite(glm::length(light.position) + glm::length(light.intensity) +
                           glm::length(light.direction) + light.range + light.innerConeAngle +
                           light.outerConeAngle + light.radius + light.shadowNear))
            return wrong("lighting", "a point or spot light is not finite.");
    if (auto ok = checkPatterns(lighting.punctual, stores.lightPatterns); !ok) return ok;
    if (auto ok = checkAreaLights(lighting.area); !ok) return ok;
    if (input.world && !stores.worlds.find(input.world))
        return wrong("frame", "its world is a stale handle.");
    for (const auto& [name, value] :
         {std::pair("lodPixelError", input.settings.lodPixelError),
          std::pair("shadowLodTexelError", input.settings.shadowLodTexelError),
          std::pair("smallObjectPixels", input.settings.smallObjectPixels)})
        if (!(value >= 0) || !std::isfinite(value))
            return wrong("settings", std::string(name) + " is " + std::to_string(value) +
                                         "; it must be finite and not negative.");
    if (lighting.environment && !stores.environments.find(lighting.environment))
        return wrong("lighting", "the environment is a stale handle.");
    if (auto ok = checkReflectionProbes(lighting.reflectionProbes); !ok) return ok;
    for (size_t i = 0; i < lighting.reflectionProbes.size(); ++i)
        if (!stores.environments.find(lighting.reflectionProbes[i].environment))
            return fail("reflection probe " + std::to_string(i),
                        "its environment is none or a stale handle.", ErrorKind::wrongUse);
    if (lighting.irradianceVolume && !stores.irradianceVolumes.find(lighting.irradianceVolume))
        return wrong("lighting", "the irradiance volume is a stale handle.");
    if (!std::isfinite(glm::length(lighting.ambientSky) + glm::length(lighting.ambientGround) +
                       glm::length(lighting.backgroundColor) + lighting.environmentRotation +
                       lighting.environmentIntensity))
        return wrong("lighting",
                     "the ambient light, the background or the environment's rotation "
                     "or intensity is not finite.");
    const SunDisk& disk = lighting.sunDisk;
    if (!(disk.radius > 0 && disk.radius < 1.5f) || !(glm::length(disk.direction) > 0) ||
        !std::isfinite(glm::length(disk.direction) + glm::length(disk.radiance)))
        return wrong("lighting",
                     "the sun's disk is not finite, has no direction, or a radius outside "
                     "of 0 to 1.5 radians.");
    if (input.decals.size() > kMaxDecals)
        return wrong("frame", "there are " + std::to_string(input.decals.size()) +
                                  " decals; at most 1,024 are possible.");
    const Fog& fog = lighting.fog;
    bool albedo = true;
    for (int c = 0; c < 3; ++c) albedo = albedo && fog.albedo[c] >= 0 && fog.albedo[c] <= 1;
    if (!(fog.density >= 0) || !std::isfinite(fog.density + fog.heightFalloff + fog.height) ||
        !(fog.heightFalloff >= 0) || !albedo || !(std::abs(fog.anisotropy) <= 0.95f) ||
        !(fog.litDistance > 0 && fog.litDistance < 1e6f))
        return wrong("fog",
                     "density and heightFalloff must be finite and not negative, height finite, "
                     "albedo 0 to 1, anisotropy -0.95 to 0.95, litDistance above 0 and below "
                     "1,000,000 metres.");
    const FrameSettings& s = input.settings;
    for (const auto& [name, value] :
         {std::pair("shadowDistance", s.shadowDistance),
          std::pair("bloomStrength", s.bloomStrength), std::pair("exposureScale", s.exposureScale),
          std::pair("exposureValue", s.exposureValue), std::pair("deltaTime", s.deltaTime)})
        if (!std::isfinite(value))
            return wrong("settings", std::string(name) + " is " + std::to_string(value) +
                                         "; it must be finite.");
    if (!(s.ambientOcclusionRadius > 0) || !std::isfinite(s.ambientOcclusionRadius))
        return wrong("settings", "ambientOcclusionRadius is " +
                                     std::to_string(s.ambientOcclusionRadius) +
                                     " m; it must be finite and over 0.");
    if (!(s.contactShadowLength > 0) || !std::isfinite(s.contactShadowLength))
        return wrong("settings", "contactShadowLength is " + std::to_string(s.contactShadowLength) +
                                     " m; it must be finite and over 0.");
    if (s.shadows && (s.shadowCascades < 1 || s.shadowCascades > 4 || s.shadowResolution < 64 ||
                      s.shadowResolution > 8192))
        return wrong("settings", "shadows need 1 to 4 cascades of 64 to 8,192 texels; " +
                                     std::to_string(s.shadowCascades) + " of " +
                                     std::to_string(s.shadowResolution) + " were asked for.");
    if (s.shadows && s.lightShadows &&
        (s.shadowAtlasSize < 256 || s.shadowAtlasSize > 16384 || s.shadowTileSize < 64 ||
         s.shadowTileSize > s.shadowAtlasSize))
        return wrong("settings",
                     "shadows of lights need an atlas of 256 to 16,384 texels "
                     "and tiles of 64 texels to its size; " +
                         std::to_string(s.shadowAtlasSize) + " and " +
                         std::to_string(s.shadowTileSize) + " were asked for.");
    return {};
}

}  // namespace rushlight

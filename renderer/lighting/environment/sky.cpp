#include "renderer/lighting/environment/sky.h"

#include "interop/tonemap.h"
#include "renderer/lighting/environment/atmosphere.h"
#include "renderer/lighting/environment/equirect.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace rushlight {
namespace {

/// Lux of the sun outside of the atmosphere (Darula, Kittler and Gueymard 2005, "Reference luminous
/// solar constant").
constexpr float kSolarIlluminance = 133800;
/// Lux under which level ground is as bright in the picture, before tone mapping, as its albedo:
/// the exposure's factor is 1 / (1.2 * 2^EV100), and light becomes radiance by 1 / pi.
constexpr float kLuxAtEv0 = 1.2f * kPi;

Result<void> check(const SkyDesc& desc) {
    const auto outside = [](const char* name, float value, const char* range) {
        return fail(
            "sky",
            std::string(name) + " is " + std::to_string(value) + "; it must be " + range + ".",
            ErrorKind::wrongUse);
    };
    const float length = glm::length(desc.sunDirection);
    if (!(length > 0) || !std::isfinite(length))
        return fail("sky", "The direction to the sun is zero or not finite.", ErrorKind::wrongUse);
    if (!(desc.turbidity >= 1 && desc.turbidity <= 10))
        return outside("turbidity", desc.turbidity, "1 to 10");
    if (!(desc.height >= 0 && desc.height <= 50000))
        return outside("height", desc.height, "0 to 50,000 metres");
    for (int c = 0; c < 3; ++c)
        if (!(desc.groundAlbedo[c] >= 0 && desc.groundAlbedo[c] <= 1))
            return outside("groundAlbedo", desc.groundAlbedo[c], "0 to 1");
    if (desc.width < 16 || desc.width > 4096)
        return outside("width", float(desc.width), "16 to 4,096 pixels");
    return {};
}

/// The factor on Atmosphere's haze that gives a turbidity: (molecules + haze) / molecules, of a
/// column of air, in green.
float hazeOf(float turbidity) {
    constexpr float molecules = 13.66e-3f * 8;
    constexpr float haze = (3.996e-3f + 4.40e-3f) * 1.2f;
    return (turbidity - 1) * molecules / haze;
}

}  // namespace

Result<Sky> makeSky(const SkyDesc& desc, JobSystem& jobs) {
    if (auto ok = check(desc); !ok) return tl::unexpected(ok.error());
    const vec3 sun = glm::normalize(desc.sunDirection);
    const Atmosphere air(hazeOf(desc.turbidity), desc.groundAlbedo, jobs);
    // Over the very ground, rays that graze it are lost in rounding.
    const float height = std::max(desc.height * 1e-3f, 1e-3f);

    Sky sky;
    sky.width = desc.width;
    sky.height = desc.width / 2;
    sky.pixels.resize(size_t(sky.width) * sky.height);
    std::vector<vec3> rows(sky.height, vec3(0));
    jobs.forRanges(sky.height, 4, [&](uint32_t begin, uint32_t end) {
        for (uint32_t y = begin; y < end; ++y) {
            const float solidAngle = equirectTexelSolidAngle(y, sky.width, sky.height);
            for (uint32_t x = 0; x < sky.width; ++x) {
                const vec3 direction = equirectDirection((float(x) + 0.5f) / float(sky.width),
                                                         (float(y) + 0.5f) / float(sky.height));
                const vec3 radiance = air.radiance(height, direction, sun) * kSolarIlluminance;
                sky.pixels[size_t(y) * sky.width + x] = radiance;
                rows[y] += radiance * (std::max(direction.y, 0.0f) * solidAngle);
            }
        }
    });
    for (const vec3& row : rows) sky.skyIlluminance += row;

    // The disk sets as it sinks below the horizon of the eye, over its own diameter.
    const float radius = Atmosphere::kGroundRadius + height;
    const float dip = std::acos(std::min(Atmosphere::kGroundRadius / radius, 1.0f));
    const float elevation = std::asin(std::clamp(sun.y, -1.0f, 1.0f)) + dip;
    const float shown = glm::smoothstep(-kSunAngularRadius, kSunAngularRadius, elevation);
    const vec3 through = air.transmittance(height, std::max(sun.y, -std::sin(dip)));
    sky.sun.direction = -sun;
    sky.sun.illuminance = through * (kSolarIlluminance * shown);
    sky.sunRadiance = through * (kSolarIlluminance / (kPi * kSunAngularRadius * kSunAngularRadius));
    const float lux = interop::luminance(sky.skyIlluminance) +
                      interop::luminance(sky.sun.illuminance) * std::max(sun.y, 0.0f);
    sky.exposureValue = std::log2(std::max(lux, 1e-3f) / kLuxAtEv0);
    return sky;
}

}  // namespace rushlight

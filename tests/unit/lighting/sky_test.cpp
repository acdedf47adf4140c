// The clear sky: against closed forms, published illuminances, and bad input.

#include "renderer/lighting/environment/sky.h"

#include "renderer/lighting/environment/atmosphere.h"
#include "tests/support/thread_jobs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace rushlight {
namespace {

vec3 towardsSun(float degrees) {
    const float a = glm::radians(degrees);
    return {std::cos(a), std::sin(a), 0};
}

Sky skyAt(float sunDegrees, float turbidity = 3) {
    SerialJobs jobs;
    SkyDesc desc;
    desc.sunDirection = towardsSun(sunDegrees);
    desc.turbidity = turbidity;
    desc.width = 64;
    return *makeSky(desc, jobs);
}

float luminance(const vec3& rgb) { return glm::dot(rgb, vec3(0.2126f, 0.7152f, 0.0722f)); }

const vec3& pixelTowards(const Sky& sky, float azimuthDegrees, float elevationDegrees) {
    const float u = azimuthDegrees / 360 + 0.5f, v = 0.5f - elevationDegrees / 180;
    return sky.pixels[size_t(v * float(sky.height)) * sky.width + size_t(u * float(sky.width))];
}

TEST(Atmosphere, TransmittanceStraightUpIsTheColumnsOpticalDepth) {
    SerialJobs jobs;
    const Atmosphere clear(0, vec3(0), jobs);
    // Molecules: coefficient times scale height; ozone: a tent of 15 km half width; per primary.
    const vec3 depth = vec3(8.90e-3f, 13.66e-3f, 26.77e-3f) * 8.0f +
                       vec3(2.28e-3f, 1.86e-3f, 0.226e-3f) * 15.0f;
    const vec3 got = clear.transmittance(0, 1);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], std::exp(-depth[c]), 0.002f) << c;
    // The planet is in the way.
    EXPECT_EQ(clear.transmittance(0.5f, -0.1f), vec3(0));
}

TEST(Atmosphere, AirMassGrowsTowardsTheHorizonAsMeasured) {
    SerialJobs jobs;
    const Atmosphere clear(0, vec3(0), jobs);
    // Kasten and Young 1989: air mass 5.59 at 10 degrees of elevation.
    const float up = -std::log(clear.transmittance(0, 1).x);
    const float low = -std::log(clear.transmittance(0, std::sin(glm::radians(10.0f))).x);
    EXPECT_NEAR(low / up, 5.59f, 0.25f);
}

TEST(Atmosphere, ScattersNoMoreLightThanItTakesFromTheSun) {
    // Above a black ground what comes down is at most what the sun sends through a level plane.
    SerialJobs jobs;
    for (const float haze : {0.0f, 10.0f, 60.0f}) {
        const Atmosphere air(haze, vec3(0), jobs);
        const vec3 sun = towardsSun(50);
        vec3 down(0);
        const uint32_t count = 64;
        for (uint32_t y = 0; y < count; ++y)
            for (uint32_t x = 0; x < count; ++x) {
                const float z = (float(y) + 0.5f) / count, phi = 2 * kPi * float(x) / count;
                const float r = std::sqrt(1 - z * z);
                down += air.radiance(0.01f, {r * std::cos(phi), z, r * std::sin(phi)}, sun) *
                        (z * 2 * kPi / (count * count));
            }
        const vec3 total = down + air.transmittance(0.01f, sun.y) * sun.y;
        for (int c = 0; c < 3; ++c) {
            EXPECT_LT(total[c], sun.y) << haze;
            EXPECT_GT(total[c], sun.y * (c == 2 ? 0.3f : 0.45f)) << haze;
        }
    }
}

TEST(Sky, ClearNoonHasTheIlluminanceThatIsMeasuredOutdoors) {
    const Sky sky = skyAt(60);
    const float direct = luminance(sky.sun.illuminance) * std::sin(glm::radians(60.0f));
    EXPECT_GT(direct, 60000);
    EXPECT_LT(direct, 100000);
    EXPECT_GT(luminance(sky.skyIlluminance), 8000);
    EXPECT_LT(luminance(sky.skyIlluminance), 30000);
    EXPECT_NEAR(sky.exposureValue, 14.7f, 0.4f);
    // Blue a quarter of the sky away from the sun, paler at the horizon, and the ground is there.
    const Sky clear = skyAt(60, 2);
    const vec3 away = pixelTowards(clear, 179, 40), horizon = pixelTowards(clear, 179, 4);
    EXPECT_GT(away.z, 2 * away.x);
    EXPECT_GT(horizon.x / horizon.z, 1.3f * away.x / away.z);
    EXPECT_GT(luminance(pixelTowards(clear, 0, -60)), 1000);
}

TEST(Sky, TheSunReddensAsItSinksAndIsGoneAtNight) {
    const Sky noon = skyAt(60), evening = skyAt(3), dusk = skyAt(-6), night = skyAt(-18);
    const auto redness = [](const Sky& s) { return s.sun.illuminance.x / s.sun.illuminance.z; };
    EXPECT_GT(redness(evening), 3 * redness(noon));
    EXPECT_EQ(dusk.sun.illuminance, vec3(0));
    // Civil twilight ends at about 3 lux; a night without moon has thousandths.
    EXPECT_GT(luminance(dusk.skyIlluminance), 0.8f);
    EXPECT_LT(luminance(dusk.skyIlluminance), 12);
    EXPECT_LT(luminance(night.skyIlluminance), 0.05f);
    EXPECT_GT(noon.exposureValue, dusk.exposureValue + 10);
}

TEST(Sky, HazeBrightensTheAureoleAndDimsTheSun) {
    const Sky clear = skyAt(40, 2), hazy = skyAt(40, 8);
    EXPECT_LT(luminance(hazy.sun.illuminance), 0.8f * luminance(clear.sun.illuminance));
    EXPECT_GT(luminance(pixelTowards(hazy, 0, 46)), 1.5f * luminance(pixelTowards(clear, 0, 46)));
}

TEST(Sky, ThreadsChangeNoByteAndNothingIsNegativeOrNotFinite) {
    SkyDesc desc;
    desc.sunDirection = towardsSun(1);
    desc.width = 32;
    SerialJobs serial;
    ThreadJobs threads(4);
    const Sky a = *makeSky(desc, serial), b = *makeSky(desc, threads);
    ASSERT_EQ(a.pixels.size(), b.pixels.size());
    EXPECT_EQ(std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(vec3)), 0);
    EXPECT_EQ(a.skyIlluminance, b.skyIlluminance);
    for (float elevation : {90.0f, 0.0f, -0.3f, -30.0f, -90.0f})
        for (const vec3& p : skyAt(elevation).pixels)
            for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(p[c]) && p[c] >= 0) << elevation;
}

TEST(Sky, BadValuesAreNamed) {
    SerialJobs jobs;
    const auto message = [&](auto&& change) {
        SkyDesc desc;
        desc.width = 16;
        change(desc);
        const auto sky = makeSky(desc, jobs);
        return sky ? std::string() : sky.error().text();
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(message([](SkyDesc& d) { d.sunDirection = vec3(0); }).find("direction"),
              std::string::npos);
    EXPECT_NE(message([&](SkyDesc& d) { d.sunDirection.x = nan; }).find("direction"),
              std::string::npos);
    EXPECT_NE(message([](SkyDesc& d) { d.turbidity = 0.5f; }).find("turbidity"), std::string::npos);
    EXPECT_NE(message([&](SkyDesc& d) { d.turbidity = nan; }).find("turbidity"), std::string::npos);
    EXPECT_NE(message([](SkyDesc& d) { d.groundAlbedo.y = 2; }).find("groundAlbedo"),
              std::string::npos);
    EXPECT_NE(message([](SkyDesc& d) { d.height = -1; }).find("height"), std::string::npos);
    EXPECT_NE(message([](SkyDesc& d) { d.width = 8; }).find("width"), std::string::npos);
    EXPECT_EQ(message([](SkyDesc&) {}), "");
}

}  // namespace
}  // namespace rushlight

// Environments that come prefiltered, in the renderer's levels of roughness.

#include "engine/core/jobs.h"
#include "renderer/geometry/half.h"
#include "renderer/lighting/environment/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rushlight {
namespace {

vec3 texelOf(const CubeTexels& cube, uint32_t level, uint32_t face, uint32_t x, uint32_t y) {
    const uint16_t* t = &cube.face(level, face)[(size_t(y) * cube.levelSize(level) + x) * 4];
    return {fromHalf(t[0]), fromHalf(t[1]), fromHalf(t[2])};
}

vec3 directionOf(uint32_t size, uint32_t face, uint32_t x, uint32_t y) {
    return glm::normalize(cubeDirection(face, (float(x) + 0.5f) * 2 / float(size) - 1,
                                        (float(y) + 0.5f) * 2 / float(size) - 1));
}

template <class F>
std::vector<vec3> makeTexels(uint32_t size, uint32_t levels, F&& radiance) {
    std::vector<vec3> texels;
    for (uint32_t level = 0; level < levels; ++level)
        for (uint32_t face = 0; face < 6; ++face)
            for (uint32_t y = 0; y < size >> level; ++y)
                for (uint32_t x = 0; x < size >> level; ++x)
                    texels.push_back(radiance(level, directionOf(size >> level, face, x, y)));
    return texels;
}

template <class F>
void forTexels(const CubeTexels& cube, uint32_t level, F&& f) {
    const uint32_t size = cube.levelSize(level);
    for (uint32_t face = 0; face < 6; ++face)
        for (uint32_t y = 0; y < size; ++y)
            for (uint32_t x = 0; x < size; ++x)
                f(directionOf(size, face, x, y), texelOf(cube, level, face, x, y));
}

PrefilteredEnvironmentDesc descOf(uint32_t size, uint32_t levels, const std::vector<vec3>& texels) {
    PrefilteredEnvironmentDesc desc;
    desc.label = "light";
    desc.size = size;
    desc.levels = levels;
    desc.texels = texels;
    return desc;
}

TEST(EnvironmentImport, LevelsOfOurOwnStayWhatTheyAre) {
    SerialJobs jobs;
    std::vector<vec3> pixels(64 * 32);
    for (uint32_t i = 0; i < pixels.size(); ++i)
        pixels[i] = vec3(float(i % 64) / 16, float(i / 64) / 8, i % 7 == 0 ? 3 : 0);
    const auto own = prefilterEnvironment({"own", 64, 32, pixels}, jobs);
    ASSERT_TRUE(own);
    std::vector<vec3> texels;
    for (uint32_t level = 0; level < kEnvironmentLevels; ++level)
        for (uint32_t face = 0; face < 6; ++face)
            for (uint32_t i = 0;
                 i < own->specular.levelSize(level) * own->specular.levelSize(level); ++i)
                texels.push_back(texelOf(own->specular, level, face,
                                         i % own->specular.levelSize(level),
                                         i / own->specular.levelSize(level)));
    const auto back = convertPrefiltered(descOf(kEnvironmentSize, kEnvironmentLevels, texels),
                                         jobs);
    ASSERT_TRUE(back) << back.error().text();
    ASSERT_EQ(back->specular.halves.size(), own->specular.halves.size());
    for (size_t i = 0; i < own->specular.halves.size(); ++i)
        ASSERT_NEAR(fromHalf(back->specular.halves[i]), fromHalf(own->specular.halves[i]), 0.02f)
            << i;
}

TEST(EnvironmentImport, OtherNumbersOfLevelsAreOfEvenlySpacedRoughnessToo) {
    SerialJobs jobs;
    const auto texels = makeTexels(32, 3,
                                   [](uint32_t level, const vec3&) { return vec3(float(level)); });
    const auto made = convertPrefiltered(descOf(32, 3, texels), jobs);
    ASSERT_TRUE(made);
    for (uint32_t level = 0; level < kEnvironmentLevels; ++level)
        forTexels(made->specular, level, [&](const vec3&, const vec3& c) {
            ASSERT_NEAR(c.x, 2 * float(level) / 5, 2e-3f) << level;
        });
}

TEST(EnvironmentImport, ASingleLevelIsBlurredHere) {
    SerialJobs jobs;
    const auto texels = makeTexels(
        64, 1, [](uint32_t, const vec3& d) { return vec3(d.y > 0 ? 1.0f : 0.0f); });
    const auto made = convertPrefiltered(descOf(64, 1, texels), jobs);
    ASSERT_TRUE(made);
    forTexels(made->specular, 0, [](const vec3& d, const vec3& c) {
        if (std::abs(d.y) > 0.05f) {
            ASSERT_NEAR(c.x, d.y > 0 ? 1 : 0, 1e-3f);
        }
    });
    forTexels(made->specular, kEnvironmentLevels - 1, [](const vec3& d, const vec3& c) {
        ASSERT_NEAR(c.x, 0.5f + 0.5f * d.y, 0.06f);  // the cosine's lobe over half a sphere
    });
}

TEST(EnvironmentImport, IrradianceIsWhatItsHarmonicsSay) {
    SerialJobs jobs;
    const auto texels = makeTexels(8, 2, [](uint32_t, const vec3&) { return vec3(1); });
    PrefilteredEnvironmentDesc desc = descOf(8, 2, texels);
    // Of the radiance 1 + x/2 + y/4 - z/8 the irradiance is pi (1 + 2/3 (x/2 + y/4 - z/8)).
    const float band0 = kPi / 0.282095f, band1 = 2 * kPi / 3 / 0.488603f;
    desc.irradiance[0] = vec3(band0);
    desc.irradiance[1] = vec3(band1 / 4);
    desc.irradiance[2] = vec3(-band1 / 8);
    desc.irradiance[3] = vec3(band1 / 2);
    const auto turn = glm::angleAxis(0.8f, glm::normalize(vec3(1, 2, 3)));
    for (const quat& rotation : {quat(1, 0, 0, 0), turn}) {
        desc.rotation = rotation;
        const auto made = convertPrefiltered(desc, jobs);
        ASSERT_TRUE(made);
        forTexels(made->irradiance, 0, [&](const vec3& world, const vec3& c) {
            const vec3 d = glm::inverse(rotation) * world;
            ASSERT_NEAR(c.x, 1 + (d.x / 2 + d.y / 4 - d.z / 8) * 2 / 3, 2e-3f);
        });
    }
    // Of x² the second band has (x² - 1/3), whose irradiance is pi/4 of it.
    desc.rotation = quat(1, 0, 0, 0);
    desc.irradiance = {};
    desc.irradiance[0] = vec3(band0 / 3);
    desc.irradiance[6] = vec3(-kPi / 4 / 6 / 0.315392f);
    desc.irradiance[8] = vec3(kPi / 4 / 2 / 0.546274f);
    const auto made = convertPrefiltered(desc, jobs);
    ASSERT_TRUE(made);
    forTexels(made->irradiance, 0, [](const vec3& d, const vec3& c) {
        ASSERT_NEAR(c.x, 1.0f / 3 + (d.x * d.x - 1.0f / 3) / 4, 2e-3f);
    });
}

TEST(EnvironmentImport, AllOfItIsTurned) {
    SerialJobs jobs;
    const auto texels = makeTexels(64, 2, [](uint32_t, const vec3& d) { return d + 1.0f; });
    PrefilteredEnvironmentDesc desc = descOf(64, 2, texels);
    desc.rotation = glm::angleAxis(1.1f, glm::normalize(vec3(-1, 0.5f, 2)));
    const auto made = convertPrefiltered(desc, jobs);
    ASSERT_TRUE(made);
    const auto check = [&](const vec3& world, const vec3& c) {
        const vec3 d = glm::inverse(desc.rotation) * world + 1.0f;
        for (int i = 0; i < 3; ++i) ASSERT_NEAR(c[i], d[i], 0.02f);
    };
    for (uint32_t level = 0; level < 3; ++level) forTexels(made->specular, level, check);
    forTexels(made->background, 0, check);
}

TEST(EnvironmentImport, WhatDoesNotFitIsRefused) {
    SerialJobs jobs;
    const std::vector<vec3> texels(6 * 16 + 6 * 4, vec3(1));
    const auto refusal = [&](auto change) {
        PrefilteredEnvironmentDesc desc = descOf(4, 2, texels);
        change(desc);
        const auto made = convertPrefiltered(desc, jobs);
        return made ? std::string() : made.error().text();
    };
    EXPECT_EQ(refusal([](auto&) {}), "");
    EXPECT_NE(refusal([](auto& d) { d.size = 0; }).find("faces of 0"), std::string::npos);
    EXPECT_NE(refusal([](auto& d) { d.size = 3; }).find("power of two"), std::string::npos);
    EXPECT_NE(refusal([](auto& d) { d.size = 65536; }).find("65536"), std::string::npos);
    EXPECT_NE(refusal([](auto& d) { d.levels = 4; }).find("4 levels"), std::string::npos);
    EXPECT_NE(refusal([](auto& d) { d.levels = 1; }).find("120 texels"), std::string::npos);
    EXPECT_NE(refusal([](auto& d) {
                  d.irradiance[4].y = std::numeric_limits<float>::infinity();
              }).find("finite"),
              std::string::npos);
    EXPECT_NE(refusal([](auto& d) { d.rotation = quat(0, 0, 0, 0); }).find("quaternion"),
              std::string::npos);
}

}  // namespace
}  // namespace rushlight

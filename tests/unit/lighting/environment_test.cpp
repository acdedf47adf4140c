// Cube orientation, irradiance, prefiltering and the cache on disk.

#include "renderer/lighting/environment/environment.h"
#include "engine/jobs/tbb_jobs.h"
#include "interop/brdf.h"
#include "renderer/geometry/half.h"
#include "renderer/lighting/brdf_table.h"
#include "renderer/lighting/environment/cube_image.h"
#include "renderer/lighting/environment/environment_cache.h"
#include "renderer/lighting/environment/equirect.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace rushlight {
namespace {

struct Picture {
    uint32_t width = 0, height = 0;
    std::vector<vec3> pixels;

    Picture(uint32_t w, uint32_t h, const vec3& fill) : width(w), height(h), pixels(w * h, fill) {}
    EnvironmentDesc desc() const { return {"test", width, height, pixels}; }
    vec3& towards(const vec3& d) {
        const uint32_t x = uint32_t((std::atan2(d.z, d.x) / (2 * kPi) + 0.5f) * float(width));
        const uint32_t y = uint32_t((0.5f - std::asin(d.y) / kPi) * float(height));
        return pixels[size_t(std::min(y, height - 1)) * width + x % width];
    }
};

vec3 texel(std::span<const uint16_t> face, uint32_t size, uint32_t x, uint32_t y) {
    const uint16_t* t = &face[(size_t(y) * size + x) * 4];
    return {fromHalf(t[0]), fromHalf(t[1]), fromHalf(t[2])};
}

/// What GL's table 8.19 says about major axes, typed out apart from the code under test.
CubePoint glLookUp(const vec3& r) {
    const vec3 a = glm::abs(r);
    float sc, tc, ma;
    uint32_t face;
    if (a.x >= a.y && a.x >= a.z)
        face = r.x > 0 ? 0 : 1, sc = r.x > 0 ? -r.z : r.z, tc = -r.y, ma = a.x;
    else if (a.y >= a.z)
        face = r.y > 0 ? 2 : 3, sc = r.x, tc = r.y > 0 ? r.z : -r.z, ma = a.y;
    else
        face = r.z > 0 ? 4 : 5, sc = r.z > 0 ? r.x : -r.x, tc = -r.y, ma = a.z;
    return {face, sc / ma, tc / ma};
}

/// Irradiance over pi at the texel's centre that is nearest to a unit direction.
vec3 irradianceNear(const PrefilteredEnvironment& environment, const vec3& direction,
                    vec3* at = {}) {
    const CubePoint p = glLookUp(direction);
    const CubeTexels& cube = environment.irradiance;
    const auto place = [&](float s) {
        return std::min(uint32_t((s * 0.5f + 0.5f) * float(cube.size)), cube.size - 1);
    };
    const uint32_t x = place(p.s), y = place(p.t);
    const float scale = 2.0f / float(cube.size);
    if (at)
        *at = glm::normalize(
            cubeDirection(p.face, (float(x) + 0.5f) * scale - 1, (float(y) + 0.5f) * scale - 1));
    return texel(cube.face(0, p.face), cube.size, x, y);
}

TEST(CubeImage, DirectionsAndPointsAreInverse) {
    for (uint32_t face = 0; face < 6; ++face)
        for (const float s : {-0.9f, 0.2f})
            for (const float t : {-0.4f, 0.7f}) {
                const vec3 d = cubeDirection(face, s, t) * 3.0f;
                for (const CubePoint& p : {cubePoint(d), glLookUp(d)}) {
                    EXPECT_EQ(p.face, face);
                    EXPECT_NEAR(p.s, s, 1e-6f);
                    EXPECT_NEAR(p.t, t, 1e-6f);
                }
            }
}

TEST(CubeImage, SolidAnglesAddUpToTheSphere) {
    double sum = 0;
    for (uint32_t y = 0; y < 16; ++y)
        for (uint32_t x = 0; x < 16; ++x) sum += cubeTexelSolidAngle(x, y, 16);
    EXPECT_NEAR(6 * sum, 4 * kPi, 1e-5);
}

TEST(Environment, ABrightTexelIsFoundWhereGlLooksForIt) {
    SerialJobs jobs;
    for (const vec3& d : {vec3(.8f, .3f, -.5f), vec3(-.9f, -.2f, .3f), vec3(.2f, .9f, .3f),
                          vec3(-.3f, -.9f, .25f), vec3(.3f, -.2f, .9f), vec3(.1f, .35f, -.9f)}) {
        const vec3 direction = glm::normalize(d);
        Picture picture(512, 256, vec3(0));
        picture.towards(direction) = vec3(100, 10, 1);
        const auto environment = prefilterEnvironment(picture.desc(), jobs);
        ASSERT_TRUE(environment);
        const CubePoint p = glLookUp(direction);
        for (const CubeTexels* cube : {&environment->background, &environment->specular}) {
            float best = -1;
            uint32_t bestFace = 9, bestX = 0, bestY = 0;
            for (uint32_t face = 0; face < 6; ++face)
                for (uint32_t y = 0; y < cube->size; ++y)
                    for (uint32_t x = 0; x < cube->size; ++x) {
                        const float value = texel(cube->face(0, face), cube->size, x, y).x;
                        if (value > best) best = value, bestFace = face, bestX = x, bestY = y;
                    }
            const float size = float(cube->size);
            EXPECT_EQ(bestFace, p.face);
            EXPECT_NEAR((float(bestX) + 0.5f) / size * 2 - 1, p.s, 3 * 2 / size * 2);
            EXPECT_NEAR((float(bestY) + 0.5f) / size * 2 - 1, p.t, 3 * 2 / size * 2);
        }
    }
}

TEST(Environment, WhiteStaysWhiteAtEveryLevel) {
    SerialJobs jobs;
    const Picture picture(64, 32, vec3(1, 2, 0.5f));
    const auto environment = prefilterEnvironment(picture.desc(), jobs);
    ASSERT_TRUE(environment);
    for (const vec3& n : {vec3(0, 1, 0), vec3(0, -1, 0), glm::normalize(vec3(1, 2, 3))}) {
        const vec3 e = irradianceNear(*environment, n);
        EXPECT_NEAR(e.x, 1, 1e-3f);
        EXPECT_NEAR(e.y, 2, 2e-3f);
    }
    const CubeTexels& cube = environment->specular;
    for (uint32_t level = 0; level < cube.levels; ++level)
        for (uint32_t face = 0; face < 6; ++face) {
            const auto t = texel(cube.face(level, face), cube.levelSize(level), 3, 5);
            EXPECT_NEAR(t.x, 1, 1e-3f) << level << " " << face;
            EXPECT_NEAR(t.z, 0.5f, 1e-3f);
        }
}

TEST(Environment, IrradianceOfAHemisphereByHand) {
    // Radiance 1 from above: E/pi = (1 + cos) / 2 for a normal at that angle from up.
    SerialJobs jobs;
    Picture picture(128, 64, vec3(0));
    for (size_t i = 0; i < picture.pixels.size() / 2; ++i) picture.pixels[i] = vec3(1);
    const auto environment = prefilterEnvironment(picture.desc(), jobs);
    ASSERT_TRUE(environment);
    for (const vec3& n : {vec3(0, 1, 0), vec3(1, 0, 0), vec3(0, -1, 0), vec3(1, 1, 0)}) {
        vec3 at;
        const vec3 e = irradianceNear(*environment, glm::normalize(n), &at);
        EXPECT_NEAR(e.x, 0.5f + 0.5f * at.y, 0.005f);
    }
}

TEST(Environment, IrradianceOfAWindowByHand) {
    // A small source of power w in direction d: E/pi = w max(n.d, 0) / pi, which nine spherical
    // harmonics miss by more than a tenth.
    SerialJobs jobs;
    Picture picture(256, 128, vec3(0));
    const vec3 window = glm::normalize(vec3(0.6f, 0.5f, -0.4f));
    picture.towards(window) = vec3(2000);
    const uint32_t row = uint32_t((0.5f - std::asin(window.y) / kPi) * 128);
    const float power = 2000 * equirectTexelSolidAngle(row, 256, 128);
    const auto environment = prefilterEnvironment(picture.desc(), jobs);
    ASSERT_TRUE(environment);
    for (const vec3& n : {window, vec3(0, 1, 0), vec3(1, 0, 0), vec3(0, 0, -1), vec3(-1, 0, 0)}) {
        vec3 at;
        const vec3 e = irradianceNear(*environment, n, &at);
        EXPECT_NEAR(e.x, power * std::max(glm::dot(at, window), 0.0f) / kPi, 0.02f * power / kPi);
    }
}

TEST(Environment, IrradianceOfTheEquirectAxesPointsTheRightWay) {
    SerialJobs jobs;
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0f, -1.0f}) {
            vec3 d(0);
            d[axis] = sign;
            Picture picture(128, 64, vec3(0));
            picture.towards(glm::normalize(d + vec3(0.02f, 0.02f, 0.02f))) = vec3(100);
            const auto environment = prefilterEnvironment(picture.desc(), jobs);
            ASSERT_TRUE(environment);
            EXPECT_GT(irradianceNear(*environment, d).x, 4 * irradianceNear(*environment, -d).x);
        }
}

TEST(Environment, ABrightSunKeepsItsEnergyAndDoesNotSparkle) {
    SerialJobs jobs;
    Picture picture(512, 256, vec3(0));
    const vec3 sun = glm::normalize(vec3(0.5f, 0.4f, 0.3f));
    picture.towards(sun) = vec3(50000);
    const auto environment = prefilterEnvironment(picture.desc(), jobs);
    ASSERT_TRUE(environment);
    const uint32_t row = uint32_t((0.5f - std::asin(sun.y) / kPi) * 256);
    const float power = 50000 * equirectTexelSolidAngle(row, 512, 256);
    const CubeTexels& cube = environment->specular;
    for (uint32_t level = 2; level < cube.levels; ++level) {
        const uint32_t size = cube.levelSize(level);
        double sum = 0, roughness = 0, peak = 0, expectedPeak = 0;
        for (uint32_t face = 0; face < 6; ++face)
            for (uint32_t y = 0; y < size; ++y)
                for (uint32_t x = 0; x < size; ++x) {
                    const double value = texel(cube.face(level, face), size, x, y).x;
                    sum += value * cubeTexelSolidAngle(x, y, size);
                    peak = std::max(peak, value);
                }
        roughness = double(level) / (cube.levels - 1);
        // The filter is normalised by the sum of n.l, so that a point of light adds up to its power
        // times the ratio of the lobe's integral over light and over normals, which is 1.
        EXPECT_NEAR(sum / power, 1, 0.06) << "level " << level;
        // The lobe's value at its centre: D / 4 over the mean of n.l, at most D / 4 / (mean n.l).
        const double alpha2 = std::pow(roughness, 4);
        double mean = 0, count = 0;
        for (int i = 0; i < 4096; ++i) {
            const double u = (i + 0.5) / 4096, c2 = (1 - u) / (1 + (alpha2 - 1) * u);
            const double light = 2 * c2 - 1;
            if (light > 0) mean += light;
            ++count;
        }
        expectedPeak = power / (4 * kPi * alpha2) / (mean / count);
        // Source texels on a grid vary the filter's height by where the sun falls; a point-sampled
        // source would be many times over.
        EXPECT_LT(peak, 1.25 * expectedPeak) << "level " << level;
    }
}

TEST(Environment, ThreadsDoNotChangeABit) {
    Picture picture(256, 128, vec3(0.1f));
    for (size_t i = 0; i < picture.pixels.size(); ++i)
        picture.pixels[i] = vec3(float(i % 97), float(i % 31), float(i % 7)) * 0.1f;
    SerialJobs serial;
    const auto threads = createTbbJobs(4);
    const auto a = prefilterEnvironment(picture.desc(), serial);
    const auto b = prefilterEnvironment(picture.desc(), *threads);
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->specular.halves, b->specular.halves);
    EXPECT_EQ(a->background.halves, b->background.halves);
    EXPECT_EQ(a->irradiance.halves, b->irradiance.halves);
}

TEST(Environment, RefusesWhatIsNoPictureAndSurvivesBadTexels) {
    SerialJobs jobs;
    Picture picture(16, 8, vec3(1));
    EnvironmentDesc desc = picture.desc();
    desc.width = 17;
    EXPECT_FALSE(prefilterEnvironment(desc, jobs));
    desc.width = 0;
    EXPECT_FALSE(prefilterEnvironment(desc, jobs));
    picture.pixels[3] = vec3(NAN, INFINITY, -5);
    const auto environment = prefilterEnvironment(picture.desc(), jobs);
    ASSERT_TRUE(environment);
    for (const uint16_t half : environment->specular.halves) EXPECT_LE(fromHalf(half), 1.001f);
    const Picture one(1, 1, vec3(0.25f));
    ASSERT_TRUE(prefilterEnvironment(one.desc(), jobs));
}

class EnvironmentCache : public testing::Test {
protected:
    void SetUp() override {
        directory = (std::filesystem::temp_directory_path() /
                     ("rushlight-cache-" +
                      std::to_string(std::chrono::steady_clock::now().time_since_epoch().count())))
                        .string();
        hash = environmentHash(picture.desc());
        path = environmentCachePath(directory, hash);
    }
    void TearDown() override { std::filesystem::remove_all(directory); }

    static void count(void* user, LogLevel, std::string_view) { ++*static_cast<int*>(user); }
    PrefilteredEnvironment get() {
        auto result = prefilterEnvironmentCached(picture.desc(), directory, jobs,
                                                 {count, &messages});
        EXPECT_TRUE(result);
        return *result;
    }

    SerialJobs jobs;
    Picture picture{64, 32, vec3(0.5f)};
    std::string directory, path;
    uint64_t hash = 0;
    int messages = 0;
};

TEST_F(EnvironmentCache, GivesBackTheSameBytes) {
    const auto computed = get();
    const auto loaded = loadPrefiltered(path, hash);
    ASSERT_TRUE(loaded);
    EXPECT_EQ(loaded->specular.halves, computed.specular.halves);
    EXPECT_EQ(loaded->background.halves, computed.background.halves);
    EXPECT_EQ(loaded->irradiance.halves, computed.irradiance.halves);
    EXPECT_EQ(messages, 0);
    size_t files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(directory))
        ++files;
    EXPECT_EQ(files, 1u);
    picture.pixels[7].x += 0.001f;
    EXPECT_NE(environmentHash(picture.desc()), hash);
}

TEST_F(EnvironmentCache, DamagedFilesAreRefusedAndComputedAgain) {
    const auto computed = get();
    const auto size = std::filesystem::file_size(path);
    const auto damage = [&](std::streamoff at) {
        std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
        file.seekg(at);
        const char was = char(file.get());
        file.seekp(at);
        file.put(char(was ^ 0x55));
    };
    for (const std::streamoff at : {0l, 8l, 12l, 20l, 24l, 33l, 60l, 5000l, long(size) - 1}) {
        damage(at);
        EXPECT_FALSE(loadPrefiltered(path, hash)) << at;
        EXPECT_EQ(get().specular.halves, computed.specular.halves);
        EXPECT_TRUE(loadPrefiltered(path, hash)) << at;
    }
    EXPECT_EQ(messages, 9);
    std::filesystem::resize_file(path, size - 2);
    EXPECT_FALSE(loadPrefiltered(path, hash));
    std::filesystem::resize_file(path, size + 2);
    EXPECT_FALSE(loadPrefiltered(path, hash));
    std::filesystem::resize_file(path, 0);
    EXPECT_FALSE(loadPrefiltered(path, hash));
}

}  // namespace
}  // namespace rushlight

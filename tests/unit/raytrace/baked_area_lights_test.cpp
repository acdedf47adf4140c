// Area lights in baked light: a floor under them, seen by paths without a bounce, against closed
// forms; and whole bakes.
#include "renderer/geometry/vertex_packing.h"
#include "renderer/raytrace/path_tracer.h"
#include "renderer/raytrace/probe_bake.h"

#include "interop/brdf.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/thread_jobs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace rushlight {
namespace {

constexpr uint32_t kPaths = 1 << 15;

class BakedAreaLights : public testing::Test {
protected:
    BakedAreaLights() : scene(*RayScene::create(jobs)), table(makeBrdfTable(jobs)) {
        const Shape cube = makeCube();
        Shape inside = cube;
        for (size_t i = 0; i < inside.indices.size(); i += 3)
            std::swap(inside.indices[i + 1], inside.indices[i + 2]);
        EXPECT_TRUE(scene->setMesh(MeshHandle{1}, cube.desc()));
        EXPECT_TRUE(scene->setMesh(MeshHandle{2}, inside.desc()));
        MaterialDesc grey;
        grey.baseColor = vec4(0.5f, 0.5f, 0.5f, 1);
        grey.metallic = 0;
        EXPECT_TRUE(scene->setMaterial(MaterialHandle{1}, grey));
    }
    void box(const vec3& low, const vec3& high, uint32_t material = 1, uint32_t mesh = 1) {
        Instance i;
        i.mesh = MeshHandle{mesh};
        i.material = MaterialHandle{material};
        for (int c = 0; c < 3; ++c) i.worldFromLocal[c][c] = 0.5f * (high[c] - low[c]);
        i.worldFromLocal[3] = vec4(0.5f * (low + high), 1);
        instances.push_back(i);
        ASSERT_TRUE(scene->build(instances));
    }
    void floor() {
        box({-50, -1, -50}, {50, 0, 50});
        const DirectionalLight sun{.illuminance = vec3(1)};
        underALux_ = seen({.directional = {&sun, 1}}, 0, 0, 1);
    }
    void makeMaterial(uint32_t index, const vec3& emissive, float transmission, const vec3& color) {
        MaterialDesc m;
        m.baseColor = vec4(color, 1);
        m.metallic = 0;
        m.emissive = emissive;
        m.transmission = transmission;
        ASSERT_TRUE(scene->setMaterial(MaterialHandle{index}, m));
    }

    /// Mean of what paths without a bounce see straight down over (x, 0, z).
    vec3 seen(const BakeLighting& lighting, float x, float z, uint32_t paths) {
        const BakeLight light = *BakeLight::create(lighting, jobs);
        const PathTracer tracer(*scene, light, table, 0);
        glm::dvec3 sum(0);
        for (uint32_t i = 0; i < paths; ++i) {
            RayRandom random(i);
            sum += glm::dvec3(tracer.radiance({x, 0.01f, z}, {0, -1, 0}, INFINITY, 0, random));
        }
        return vec3(sum / double(paths));
    }
    /// Of the floor, against a sun of one lux before anything hid it.
    vec3 irradiance(std::span<const AreaLight> lights, float x = 0, float z = 0) {
        return seen({.area = lights}, x, z, kPaths) / underALux_;
    }
    float irradiance(const AreaLight& light, float x = 0, float z = 0) {
        return irradiance({&light, 1}, x, z).y;
    }

    SerialJobs jobs;
    std::unique_ptr<RayScene> scene;
    BrdfTable table;
    std::vector<Instance> instances;

private:
    vec3 underALux_{0};
};

/// Shines down: cross(x, z) is -y.
AreaLight rectangleAt(const vec3& position, float halfX, float halfZ) {
    AreaLight light;
    light.position = position;
    light.halfX = {halfX, 0, 0};
    light.halfY = {0, 0, halfZ};
    light.luminance = vec3(100);
    return light;
}

/// Of a rectangle with a corner above the point, by its sides over its height; odd in both.
/// Howell's catalog, B-3.
double cornerFactor(double a, double b) {
    const double p = std::sqrt(1 + a * a), q = std::sqrt(1 + b * b);
    return (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / (2 * double(kPi));
}

void expectNear(double got, double want, double share = 0.02) {
    EXPECT_NEAR(got, want, share * want);
}

TEST_F(BakedAreaLights, ARectangleGivesItsFormFactor) {
    floor();
    for (const vec3& at : {vec3(0, 1.5f, 0), vec3(1.4f, 0.8f, -0.6f)}) {
        const AreaLight light = rectangleAt(at, 1, 0.5f);
        const double h = double(at.y), x0 = (at.x - 1) / h, x1 = (at.x + 1) / h;
        const double z0 = (at.z - 0.5) / h, z1 = (at.z + 0.5) / h;
        expectNear(double(irradiance(light)), 100 * double(kPi) *
                                                  (cornerFactor(x1, z1) - cornerFactor(x0, z1) -
                                                   cornerFactor(x1, z0) + cornerFactor(x0, z0)));
    }
}

// A disk that is parallel to the plane and beside the point: Howell's catalog, B-13.
TEST_F(BakedAreaLights, ADiskGivesItsFormFactor) {
    floor();
    for (const vec3& at : {vec3(0, 1, 0), vec3(0.9f, 0.7f, 0.5f)}) {
        AreaLight light = rectangleAt(at, 0.6f, 0.6f);
        light.shape = AreaShape::disk;
        const double a2 = double(at.x * at.x + at.z * at.z), h2 = double(at.y * at.y), r2 = 0.36;
        const double root = std::sqrt((h2 + a2 + r2) * (h2 + a2 + r2) - 4 * a2 * r2);
        expectNear(double(irradiance(light)),
                   100 * double(kPi) * 0.5 * (1 - (h2 + a2 - r2) / root));
    }
}

// Of a sphere above the horizon a surface gets pi L (r / d)^2 cos.
TEST_F(BakedAreaLights, ASphereGivesItsFormFactor) {
    floor();
    for (const vec3& at : {vec3(0, 1.2f, 0), vec3(1, 0.8f, -1), vec3(3, 4, 2)}) {
        const AreaLight light{
            .shape = AreaShape::sphere, .position = at, .radius = 0.7f, .luminance = vec3(100)};
        const double d2 = double(glm::dot(at, at));
        expectNear(double(irradiance(light)),
                   100 * double(kPi) * 0.49 / d2 * double(at.y) / std::sqrt(d2));
    }
}

/// Of the floor at the origin: the sum over all of a tube's surface.
double tubeIrradiance(const AreaLight& light) {
    constexpr int kSteps = 400;
    const double half = double(glm::length(light.halfX)), radius = double(light.radius);
    const vec3 axis = light.halfX / float(half), x = perpendicular(axis), y = glm::cross(axis, x);
    double sum = 0;
    const auto add = [&](const vec3& place, const vec3& normal, double area) {
        const vec3 p = light.position + place;
        const double d2 = double(glm::dot(p, p)), facing = -double(glm::dot(p, normal));
        if (facing > 0 && p.y > 0) sum += facing * double(p.y) / (d2 * d2) * area;
    };
    for (int i = 0; i < kSteps; ++i)
        for (int k = 0; k < kSteps; ++k) {
            const float s = (float(i) + 0.5f) / kSteps, phi = 2 * kPi * (float(k) + 0.5f) / kSteps;
            const vec3 out = x * std::cos(phi) + y * std::sin(phi);
            add(light.halfX * (2 * s - 1) + out * light.radius, out,
                4 * double(kPi) * radius * half / (kSteps * kSteps));
            for (const float end : {-1.0f, 1.0f})
                add(light.halfX * end + out * (light.radius * s), axis * end,
                    2 * double(kPi) * radius * radius * double(s) / (kSteps * kSteps));
        }
    return sum * double(light.luminance.y);
}

TEST_F(BakedAreaLights, ATubeGivesTheSumOverItsSurface) {
    floor();
    AreaLight across{.shape = AreaShape::tube,
                     .position = {0.3f, 1, 0},
                     .halfX = {0.8f, 0, 0.3f},
                     .radius = 0.1f,
                     .luminance = vec3(100)};
    AreaLight showsAnEnd = across;
    showsAnEnd.position = {1, 1.2f, 0.5f};
    showsAnEnd.halfX = {0.3f, 0.2f, 0.1f};
    showsAnEnd.radius = 0.4f;
    AreaLight fromBelow = showsAnEnd;  // the end alone
    fromBelow.position = {0, 1.2f, 0};
    fromBelow.halfX = {0, 0.5f, 0};
    for (const AreaLight& light : {across, showsAnEnd, fromBelow})
        expectNear(double(irradiance(light)), tubeIrradiance(light));
}

TEST_F(BakedAreaLights, SeveralAddUp) {
    floor();
    std::vector<AreaLight> lights{rectangleAt({-2, 1, 0}, 0.5f, 0.5f),
                                  rectangleAt({0, 3, 1}, 1, 0.2f)};
    lights.push_back({.shape = AreaShape::sphere,
                      .position = {1, 1, 1},
                      .radius = 0.2f,
                      .luminance = vec3(300)});
    lights[0].luminance = {500, 100, 0};
    vec3 sum(0);
    for (const AreaLight& light : lights) sum += irradiance({&light, 1});
    const vec3 all = irradiance(lights);
    for (int c = 0; c < 3; ++c) expectNear(double(all[c]), double(sum[c]));
}

TEST_F(BakedAreaLights, ShineToTheirSidesAndWithinTheirRange) {
    floor();
    AreaLight down = rectangleAt({0, 1.5f, 0}, 0.5f, 0.5f), up = down;
    std::swap(up.halfX, up.halfY);
    const float whole = irradiance(down);
    EXPECT_GT(whole, 0);
    EXPECT_EQ(irradiance(up), 0);
    up.twoSided = true;
    expectNear(double(irradiance(up)), double(whole));
    down.range = 2;
    expectNear(double(irradiance(down)), double(whole) * (1 - std::pow(0.75, 4)), 1e-3);
    down.range = 1.49f;
    EXPECT_EQ(irradiance(down), 0);
}

TEST_F(BakedAreaLights, AreHiddenByWhatCasts) {
    floor();
    AreaLight light = rectangleAt({0, 2, 0}, 0.5f, 0.5f);
    const float whole = irradiance(light);
    box({0, 1, -5}, {5, 1.1f, 5});  // hides the half with x > 0
    expectNear(double(irradiance(light)), 0.5 * double(whole));
    light.castsShadow = true;  // is for frames
    expectNear(double(irradiance(light)), 0.5 * double(whole));
    box({-5, 1, -5}, {0, 1.1f, 5});
    EXPECT_EQ(irradiance(light), 0);
}

TEST_F(BakedAreaLights, AreColouredByGlass) {
    floor();
    const AreaLight light = rectangleAt({0, 2, 0}, 0.3f, 0.3f);
    const vec3 clear = irradiance({&light, 1});
    makeMaterial(2, vec3(0), 1, {1, 0.25f, 0});
    box({-9, 1, -9}, {9, 1.1f, 9}, 2);
    const vec3 through = scene->transmittance({{0, 0.5f, 0}, {0, 1, 0}});
    EXPECT_GT(through.x, 0.5f);
    EXPECT_LT(through.y, 0.3f * through.x);
    const vec3 coloured = irradiance({&light, 1});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(coloured[c], clear[c] * through[c], 0.02f * clear.x);
}

// A panel 1 cm below the light, of the light's size, neither hides it nor glows a second time.
TEST_F(BakedAreaLights, WhatStandsForALightIsTheLight) {
    floor();
    AreaLight light = rectangleAt({0, 2, 0}, 0.5f, 0.5f);
    const float open = irradiance(light);
    makeMaterial(2, vec3(100), 0, vec3(0));
    box({-0.5f, 1.99f, -0.5f}, {0.5f, 1.995f, 0.5f}, 2);
    expectNear(double(irradiance(light)), double(open));
    const auto glowOf = [&](const vec3& from, const vec3& direction,
                            std::span<const AreaLight> lights) {
        const BakeLight prepared = *BakeLight::create({.area = lights}, jobs);
        RayRandom random(1);
        return PathTracer(*scene, prepared, table, 0)
            .radiance(from, direction, INFINITY, 0, random)
            .x;
    };
    const vec3 below(0.2f, 1, 0.3f), up(0, 1, 0), above(0.2f, 3, 0.3f);
    EXPECT_GE(glowOf(below, up, {}), 100);
    EXPECT_EQ(glowOf(below, up, {&light, 1}), 0);
    EXPECT_GE(glowOf(above, -up, {&light, 1}), 100);  // its back is not the light's
    light.position.y = 2.1f;
    EXPECT_GE(glowOf(below, up, {&light, 1}), 100);
}

// A lamp in the middle of a closed room: of the mean direct irradiance E on the walls each bounce
// leaves the share rho, and the probes hold what came by at least one, E rho / (1 - rho).
TEST_F(BakedAreaLights, CountFromTheirFirstBounce) {
    box(vec3(-2), vec3(2), 1, 2);
    constexpr float kHalf = 0.2f;
    const AreaLight ball{.shape = AreaShape::sphere, .radius = 0.3f, .luminance = vec3(20)};
    std::vector<AreaLight> cube;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            AreaLight face;
            face.position = face.halfX = face.halfY = vec3(0);
            face.position[axis] = side * kHalf;
            face.halfX[(axis + 1) % 3] = side * kHalf;
            face.halfY[(axis + 2) % 3] = kHalf;
            face.luminance = vec3(20);
            cube.push_back(face);
        }
    const vec2 split = table.lookUp(0.7f, 1);
    const interop::EnvironmentWeights w = interop::environmentWeights(
        vec3(0.5f), vec3(interop::kDielectricF0), split);
    const float rho = w.diffuse.x + w.specular.x;
    const auto check = [&](std::span<const AreaLight> lights, float surface) {
        const float direct = kPi * 20 * surface / (6 * 16);
        ProbeBakeDesc desc;
        desc.spacing = 0.8f;
        desc.samples = 256;
        const IrradianceVolume volume = *bakeIrradiance(*scene, {.area = lights}, desc, jobs);
        float mean = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (const float side : {-1.0f, 1.0f})
                for (int i = 0; i < 64; ++i) {
                    vec3 p(0), n(0);
                    p[axis] = side * 2;
                    p[(axis + 1) % 3] = -1.75f + 0.5f * float(i % 8);
                    p[(axis + 2) % 3] = -1.75f + 0.5f * float(i / 8);
                    n[axis] = -side;
                    mean += sampleIrradiance(volume, p, n).x * kPi / 384;
                }
        expectNear(double(mean), double(direct * rho / (1 - rho)), 0.05);
    };
    check({&ball, 1}, 4 * kPi * 0.09f);
    check(cube, 6 * 4 * kHalf * kHalf);
}

TEST_F(BakedAreaLights, BakeToTheSameBytesForAnyNumberOfThreads) {
    box(vec3(-2), vec3(2), 1, 2);
    box({-1, -2, -1}, {0, 0, 0});
    std::vector<AreaLight> lights{rectangleAt({0, 1.9f, 0}, 0.5f, 0.5f)};
    lights.push_back({.shape = AreaShape::tube, .position = {1, 1, 1}});
    lights.push_back({.shape = AreaShape::sphere, .position = {1, -1, 1}});
    ProbeBakeDesc desc;
    desc.spacing = 1;
    desc.samples = 32;
    std::vector<std::vector<std::byte>> files;
    for (const uint32_t threads : {1u, 2u, 8u}) {
        ThreadJobs some(threads);
        files.push_back(
            encodeIrradianceVolume(*bakeIrradiance(*scene, {.area = lights}, desc, some)));
    }
    EXPECT_EQ(files[0], files[1]);
    EXPECT_EQ(files[0], files[2]);
}

TEST_F(BakedAreaLights, TellLightingsApartAndAreRefusedWhenNotFinite) {
    const AreaLight plain;
    std::vector<AreaLight> others(9, plain);
    others[0].shape = AreaShape::disk;
    others[1].position.x = 1;
    others[2].halfX.x = 1;
    others[3].halfY.y = 1;
    others[4].radius = 1;
    others[5].luminance.z = 1;
    others[6].twoSided = true;
    others[7].range = 1;
    others[8].shadowNear = 1;
    const uint64_t hash = hashOf(BakeLighting{.area = {&plain, 1}});
    EXPECT_NE(hash, hashOf(BakeLighting{}));
    for (const AreaLight& other : others)
        EXPECT_NE(hashOf(BakeLighting{.area = {&other, 1}}), hash) << &other - others.data();
    AreaLight bad = plain;
    bad.halfY.x = NAN;
    EXPECT_FALSE(BakeLight::create({.area = {&bad, 1}}, jobs));
    EXPECT_TRUE(BakeLight::create({.area = {&plain, 1}}, jobs));
}

}  // namespace
}  // namespace rushlight

#include "renderer/raytrace/ray_scene.h"

#include "tests/support/random.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/thread_jobs.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>
#include <vector>

namespace rushlight {
namespace {

constexpr MeshHandle kMesh{1};
constexpr MaterialHandle kMaterial{1};
constexpr ImageHandle kImage{1};

struct Triangles {
    std::vector<vec3> positions;
    std::vector<uint32_t> indices;
    MeshDesc desc() const {
        MeshDesc d;
        d.label = "triangles";
        d.positions = positions;
        d.indices = indices;
        return d;
    }
};

Triangles randomTriangles(uint32_t count, uint64_t seed) {
    Random random(seed);
    Triangles t;
    for (uint32_t i = 0; i < count; ++i) {
        const vec3 center = random.vector(-5, 5);
        for (int c = 0; c < 3; ++c) {
            t.indices.push_back(uint32_t(t.positions.size()));
            t.positions.push_back(center + random.vector(-1, 1));
        }
    }
    return t;
}

/// A square of 2 m around the origin in the plane y = 0, seen from above; uv (0, 0) at (-1, -1).
struct Square {
    std::vector<vec3> positions{{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}};
    std::vector<vec2> uv{{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    std::vector<uint32_t> indices{0, 1, 2, 0, 2, 3};
    MeshDesc desc() const {
        MeshDesc d;
        d.label = "square";
        d.positions = positions;
        d.uv0 = uv;
        d.indices = indices;
        return d;
    }
};

std::unique_ptr<RayScene> sceneOf(JobSystem& jobs, const MeshDesc& mesh,
                                  std::span<const Instance> instances,
                                  const MaterialDesc& material = {}) {
    auto scene = *RayScene::create(jobs);
    EXPECT_TRUE(scene->setMesh(kMesh, mesh));
    EXPECT_TRUE(scene->setMaterial(kMaterial, material));
    EXPECT_TRUE(scene->build(instances));
    return scene;
}

Instance instanceAt(const vec3& place, float scaleX = 1) {
    Instance i;
    i.mesh = kMesh;
    i.material = kMaterial;
    i.worldFromLocal[0].x = scaleX;
    i.worldFromLocal[3] = place;
    return i;
}

/// Distance along the ray; infinity for a miss. Möller and Trumbore 1997, in doubles.
double distanceTo(const Ray& ray, const vec3& a, const vec3& b, const vec3& c) {
    const glm::dvec3 o = ray.origin, d = ray.direction, e1 = b - a, e2 = c - a, p = cross(d, e2);
    const double determinant = dot(e1, p), none = std::numeric_limits<double>::infinity();
    if (determinant == 0) return none;
    const glm::dvec3 s = o - glm::dvec3(a), q = cross(s, e1);
    const double u = dot(s, p) / determinant, v = dot(d, q) / determinant;
    const double t = dot(e2, q) / determinant;
    return u < 0 || v < 0 || u + v > 1 || t < 0 ? none : t;
}

TEST(RayScene, FindsWhatTestingEveryTriangleFinds) {
    SerialJobs jobs;
    const Triangles t = randomTriangles(300, 1);
    const Instance instances[] = {instanceAt({0, 0, 0}), instanceAt({3, 1, 0}, -1.5f)};
    const auto scene = sceneOf(jobs, t.desc(), instances);
    Random random(2);
    uint32_t hits = 0;
    for (uint32_t i = 0; i < 2000; ++i) {
        const Ray ray{random.vector(-8, 8), random.direction()};
        double nearest = std::numeric_limits<double>::infinity();
        vec3 normal(0);
        uint32_t instance = 0;
        for (uint32_t k = 0; k < 2; ++k)
            for (size_t j = 0; j < t.positions.size(); j += 3) {
                vec3 corners[3];
                for (size_t c = 0; c < 3; ++c)
                    corners[c] = transformPoint(instances[k].worldFromLocal, t.positions[j + c]);
                const double d = distanceTo(ray, corners[0], corners[1], corners[2]);
                if (d >= nearest) continue;
                nearest = d;
                instance = k;
                normal = glm::normalize(
                    glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
                if (k == 1) normal = -normal;  // mirrored: the front is where the object's is
            }
        RayHit hit;
        ASSERT_EQ(scene->intersect(ray, hit), std::isfinite(nearest)) << i;
        ASSERT_EQ(scene->occluded(ray), std::isfinite(nearest)) << i;
        if (!std::isfinite(nearest)) continue;
        ++hits;
        EXPECT_NEAR(hit.distance, nearest, 1e-4);
        EXPECT_LT(glm::distance(hit.position, ray.origin + float(nearest) * ray.direction), 1e-4f);
        EXPECT_EQ(hit.instance, instance);
        EXPECT_GT(glm::dot(hit.geometricNormal, normal), 0.999f);
        EXPECT_EQ(hit.front, glm::dot(normal, ray.direction) < 0);
    }
    EXPECT_GT(hits, 500u);
}

TEST(RayScene, AMaskLetsLightThroughWhereItsAlphaSaysSo) {
    SerialJobs jobs;
    const Square square;
    MaterialDesc material;
    material.baseColorTexture.image = kImage;
    material.alphaMode = AlphaMode::mask;
    std::vector<uint8_t> pixels(2 * 2 * 4, 255);
    pixels[3] = 0;  // the texel at u, v < 1/2
    auto scene = sceneOf(jobs, square.desc(), {}, material);
    ImageDesc image;
    image.width = image.height = 2;
    image.pixels = pixels;
    ASSERT_TRUE(scene->setImage(kImage, image));
    const Instance instance = instanceAt(vec3(0));
    ASSERT_TRUE(scene->build({&instance, 1}));
    const auto hits = [&](float x, float z) {
        const Ray ray{{x, 1, z}, {0, -1, 0}};
        RayHit hit;
        const bool hit1 = scene->intersect(ray, hit), hit2 = scene->occluded(ray);
        EXPECT_EQ(hit1, hit2);
        return hit1;
    };
    EXPECT_FALSE(hits(-0.5f, -0.5f));
    EXPECT_TRUE(hits(0.5f, -0.5f));
    EXPECT_TRUE(hits(-0.5f, 0.5f));
    EXPECT_TRUE(hits(0.5f, 0.5f));
}

TEST(RayScene, BlendedSurfacesAreNotThereAndOthersCastShadowsAsTheyAreTold) {
    SerialJobs jobs;
    const Square square;
    MaterialDesc glass;
    glass.alphaMode = AlphaMode::blend;
    Instance instance = instanceAt(vec3(0));
    const Ray ray{{0.2f, 1, 0.1f}, {0, -1, 0}};
    RayHit hit;
    auto scene = sceneOf(jobs, square.desc(), {&instance, 1}, glass);
    EXPECT_FALSE(scene->intersect(ray, hit));
    EXPECT_FALSE(scene->occluded(ray));

    instance.flags = 0;
    scene = sceneOf(jobs, square.desc(), {&instance, 1});
    EXPECT_TRUE(scene->intersect(ray, hit));
    EXPECT_FALSE(scene->occluded(ray));
}

TEST(RayScene, LightThatGoesThroughTakesTheColoursOfAllItMeets) {
    SerialJobs jobs;
    const Square square;
    MaterialDesc glass;
    glass.baseColor = {0.8f, 0.4f, 0.2f, 0.5f};
    glass.metallic = 0;
    glass.transmission = 0.5f;
    const vec3 once = vec3(glass.baseColor) * 0.5f;
    std::vector<Instance> panes{instanceAt(vec3(0)), instanceAt({0, -1, 0})};
    panes[1].flags = 0;
    const Ray ray{{0.2f, 1, 0.1f}, {0, -1, 0}}, back{{0.2f, -2, 0.1f}, {0, 1, 0}};
    const auto expect = [&](const vec3& got, const vec3& wanted) {
        EXPECT_LT(glm::distance(got, wanted), 1e-5f) << got.x << " " << got.y << " " << got.z;
    };
    auto scene = sceneOf(jobs, square.desc(), panes, glass);
    RayHit hit;
    EXPECT_FALSE(scene->intersect(ray, hit));
    EXPECT_FALSE(scene->occluded(ray));
    expect(scene->transmittance(ray), once);
    expect(scene->transmittance(back), once);
    expect(scene->colorBetween(ray), once * once);
    expect(scene->colorBetween({ray.origin, ray.direction, 0, 1.5f}), once);
    expect(scene->colorBetween({ray.origin, ray.direction, 1.5f, 9}), once);
    expect(scene->colorBetween({{5, 1, 0}, ray.direction}), vec3(1));

    glass.alphaMode = AlphaMode::blend;
    scene = sceneOf(jobs, square.desc(), panes, glass);
    expect(scene->transmittance(ray), glm::mix(vec3(1), once, 0.5f));

    // A closed body colours light once, unless its backs are drawn too.
    glass.alphaMode = AlphaMode::opaque;
    const Shape cube = makeCube();
    panes.resize(1);
    scene = sceneOf(jobs, cube.desc(), panes, glass);
    const Ray through{{0.2f, 5, 0.1f}, {0, -1, 0}};
    expect(scene->transmittance(through), once);
    glass.doubleSided = true;
    scene = sceneOf(jobs, cube.desc(), panes, glass);
    expect(scene->transmittance(through), once * once);
}

TEST(RayScene, ASurfaceHasItsTexturesAndFactors) {
    SerialJobs jobs;
    const Square square;
    MaterialDesc material;
    material.baseColor = {0.5f, 1, 1, 1};
    material.baseColorTexture.image = kImage;
    material.emissive = {2, 0, 0};
    material.metallic = 0.25f;
    auto scene = sceneOf(jobs, square.desc(), {}, material);
    std::vector<uint8_t> pixels(512 * 512 * 4);
    for (size_t i = 0; i < pixels.size(); ++i) pixels[i] = uint8_t(i % 4 == 3 ? 255 : 188);
    ImageDesc image{"grey", 512, 512, true, pixels};
    ASSERT_TRUE(scene->setImage(kImage, image));
    const Instance instance = instanceAt(vec3(0));
    ASSERT_TRUE(scene->build({&instance, 1}));
    RayHit hit;
    ASSERT_TRUE(scene->intersect({{0.3f, 1, 0.2f}, {0, -1, 0}}, hit));
    const RaySurface s = scene->surface(hit);
    EXPECT_NEAR(s.baseColor.x, 0.5f * 0.5029f, 1e-3f);  // 188 of 255 in sRGB
    EXPECT_NEAR(s.baseColor.y, 0.5029f, 1e-3f);
    EXPECT_EQ(s.emissive, vec3(2, 0, 0));
    EXPECT_EQ(s.metallic, 0.25f);
    EXPECT_TRUE(hit.front);
}

TEST(RayScene, WhatIsNotANumberIsLeftOutOrHitsNothing) {
    SerialJobs jobs;
    const float nan = std::nanf("");
    Triangles bad = randomTriangles(2, 3);
    auto scene = *RayScene::create(jobs);
    bad.positions[1].y = nan;
    EXPECT_FALSE(scene->setMesh(kMesh, bad.desc()));
    bad = randomTriangles(2, 3);
    bad.indices[2] = 99;
    EXPECT_FALSE(scene->setMesh(kMesh, bad.desc()));
    EXPECT_FALSE(scene->setMesh(kMesh, {}));

    Square square;
    square.indices.insert(square.indices.end(), {1, 1, 1, 0, 1, 1});  // without an area
    ASSERT_TRUE(scene->setMesh(kMesh, square.desc()));
    std::vector<Instance> instances = {instanceAt(vec3(0)), instanceAt({nan, 0, 0}),
                                       instanceAt(vec3(0), 0), instanceAt(vec3(0))};
    instances[3].mesh = MeshHandle{77};
    ASSERT_TRUE(scene->build(instances));
    EXPECT_EQ(scene->rejected(), 3u);
    RayHit hit;
    EXPECT_TRUE(scene->intersect({{0.1f, 1, 0}, {0, -1, 0}}, hit));
    const float inf = std::numeric_limits<float>::infinity();
    for (const float x : {nan, inf, -inf}) {
        EXPECT_FALSE(scene->intersect({{x, 1, 0}, {0, -1, 0}}, hit));
        EXPECT_FALSE(scene->intersect({{0, 1, 0}, {0, x, 0}}, hit));
        EXPECT_FALSE(scene->occluded({{x, 1, 0}, {0, -1, 0}}));
    }
    EXPECT_FALSE(scene->occluded({{0, 1, 0}, vec3(0)}));
    EXPECT_FALSE(scene->occluded({{0, 1, 0}, {0, -1, 0}, nan, 2}));
}

TEST(RayScene, ARayFromASurfaceDoesNotHitIt) {
    SerialJobs jobs;
    const Square square;
    Random random(5);
    uint32_t wrong = 0;
    for (uint32_t i = 0; i < 200; ++i) {
        Instance instance = instanceAt(random.vector(-300, 300), random.uniform(1, 20));
        const auto scene = sceneOf(jobs, square.desc(), {&instance, 1});
        for (uint32_t k = 0; k < 20; ++k) {
            const vec3 at = transformPoint(instance.worldFromLocal,
                                           {random.uniform(-1, 1), 0, random.uniform(-1, 1)});
            RayHit hit;
            if (!scene->intersect({at + vec3(0, 10, 0), {0, -1, 0}}, hit)) continue;
            vec3 d = random.direction();
            d.y = std::abs(d.y) * 0.1f;
            wrong += scene->occluded(
                {offsetOrigin(hit.position, hit.geometricNormal), glm::normalize(d)});
        }
    }
    EXPECT_EQ(wrong, 0u);
}

size_t threadsOfTheProcess() {
    size_t count = 0;
    for ([[maybe_unused]] const auto& entry :
         std::filesystem::directory_iterator("/proc/self/task"))
        ++count;
    return count;
}

TEST(RayScene, BuildsOnTheHostsThreads) {
    const Triangles t = randomTriangles(20000, 8);
    const size_t before = threadsOfTheProcess();
    ThreadJobs jobs(2);
    auto scene = *RayScene::create(jobs);
    std::vector<Instance> instances;
    for (uint32_t i = 0; i < 8; ++i) {
        ASSERT_TRUE(scene->setMesh(MeshHandle{i + 1}, t.desc()));
        instances.push_back(instanceAt(vec3(float(i), 0, 0)));
        instances.back().mesh = MeshHandle{i + 1};
    }
    ASSERT_TRUE(scene->build(instances));
    // A thread that was joined is listed for a moment more.
    for (int wait = 0; wait < 200 && threadsOfTheProcess() != before; ++wait)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_EQ(threadsOfTheProcess(), before);
}

TEST(RayScene, ThreadsChangeNoHit) {
    const Triangles t = randomTriangles(20000, 8);
    std::vector<std::vector<float>> distances;
    for (const uint32_t threads : {1u, 2u, 8u}) {
        ThreadJobs jobs(threads);
        auto scene = *RayScene::create(jobs);
        std::vector<Instance> instances;
        for (uint32_t i = 0; i < 8; ++i) {
            ASSERT_TRUE(scene->setMesh(MeshHandle{i + 1}, t.desc()));
            instances.push_back(instanceAt(vec3(float(i), 0, 0)));
            instances.back().mesh = MeshHandle{i + 1};
        }
        ASSERT_TRUE(scene->build(instances));
        std::vector<float>& out = distances.emplace_back(20000, -1.0f);
        jobs.forRanges(20000, 64, [&](uint32_t begin, uint32_t end) {
            for (uint32_t i = begin; i < end; ++i) {
                Random random(i);
                RayHit hit;
                if (scene->intersect({random.vector(-9, 9), random.direction()}, hit))
                    out[i] = hit.distance;
            }
        });
    }
    EXPECT_EQ(distances[0], distances[1]);
    EXPECT_EQ(distances[0], distances[2]);
}

}  // namespace
}  // namespace rushlight

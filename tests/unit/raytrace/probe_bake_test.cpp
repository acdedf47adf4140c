#include "renderer/raytrace/probe_bake.h"

#include "engine/jobs/tbb_jobs.h"
#include "interop/brdf.h"
#include "renderer/lighting/brdf_table.h"
#include "renderer/raytrace/path_tracer.h"
#include "tests/support/random.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/thread_jobs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace rushlight {
namespace {

MaterialHandle material(uint32_t i) { return MaterialHandle{i + 1}; }

/// Boxes of uniform Lambert surfaces.
class Scene {
public:
    Scene() : scene_(*RayScene::create(jobs_)) {
        cube_ = makeCube();
        inside_ = cube_;
        for (size_t i = 0; i < inside_.indices.size(); i += 3)
            std::swap(inside_.indices[i + 1], inside_.indices[i + 2]);
        EXPECT_TRUE(scene_->setMesh(MeshHandle{1}, cube_.desc()));
        EXPECT_TRUE(scene_->setMesh(MeshHandle{2}, inside_.desc()));
    }
    void paint(uint32_t index, const vec3& albedo, const vec3& emissive = vec3(0)) {
        MaterialDesc m;
        // The albedo that environmentWeights makes of a dielectric is not the base colour: of a
        // metal at roughness 1 with f0 = 1 it is 1, of black it is the specular part.
        m.baseColor = vec4(albedo, 1);
        m.metallic = 0;
        m.emissive = emissive;
        EXPECT_TRUE(scene_->setMaterial(material(index), m));
    }
    /// Seen from outside, or from inside as a room is.
    void box(const vec3& low, const vec3& high, uint32_t paint, bool room = false) {
        Instance i;
        i.mesh = MeshHandle{room ? 2u : 1u};
        i.material = material(paint);
        const vec3 half = 0.5f * (high - low);
        for (int c = 0; c < 3; ++c) i.worldFromLocal[c][c] = half[c];
        i.worldFromLocal[3] = 0.5f * (low + high);
        instances_.push_back(i);
    }
    const RayScene& build() {
        EXPECT_TRUE(scene_->build(instances_));
        return *scene_;
    }
    IrradianceVolume bake(const BakeLighting& lighting, ProbeBakeDesc desc) {
        auto jobs = createTbbJobs(0);
        auto volume = bakeIrradiance(build(), lighting, desc, *jobs);
        EXPECT_TRUE(volume) << volume.error().text();
        return volume ? *volume : IrradianceVolume{};
    }

private:
    SerialJobs jobs_;
    std::unique_ptr<RayScene> scene_;
    Shape cube_, inside_;
    std::vector<Instance> instances_;
};

float meanOf(const vec3& v) { return (v.x + v.y + v.z) / 3; }

TEST(ProbeBake, AWhiteWorldUnderAWhiteSkyIsWhiteEverywhere) {
    Scene scene;
    scene.paint(0, vec3(1));
    scene.box({-3, -1, -3}, {3, 0, 3}, 0);
    scene.box({-1, 0, -1}, {0, 2, 0}, 0);
    BakeLighting lighting;
    const std::vector<vec3> white(8 * 4, vec3(1));
    lighting.environment = {"white", 8, 4, white};
    ProbeBakeDesc desc;
    desc.spacing = 1.5f;
    desc.samples = 4096;
    desc.bounds = {vec3(-3, 0, -3), vec3(3, 3, 3)};
    const IrradianceVolume volume = scene.bake(lighting, desc);
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        const vec3 p = random.vector(-2.9f, 2.9f) * vec3(1, 0.5f, 1) + vec3(0, 1.5f, 0);
        if (p.x > -1.2f && p.x < 0.2f && p.z > -1.2f && p.z < 0.2f && p.y < 2.2f) continue;
        const vec4 s = sampleIrradiance(volume, p, random.direction());
        EXPECT_EQ(s.w, 1);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(s[c], 1, 0.03f);
    }
}

// A closed room is an integrating sphere (on the average over its walls): of light of radiosity E0
// on average, each bounce leaves the share rho, so what came by at least one bounce is E0 rho / (1
// - rho).
TEST(ProbeBake, AClosedRoomHasTheLightOfAnIntegratingSphere) {
    const float emitted = 2;  // radiance of all walls
    for (const float base : {0.2f, 0.5f, 0.8f}) {
        Scene scene;
        scene.paint(0, vec3(base), vec3(emitted));
        scene.box(vec3(-2), vec3(2), 0, true);
        ProbeBakeDesc desc;
        desc.spacing = 2;
        desc.samples = 8192;
        const IrradianceVolume volume = scene.bake({}, desc);
        // The albedo of the bounce, seen from all sides: E / pi = L0 / (1 - rho) as the walls all
        // glow alike.
        SerialJobs jobs;
        const BrdfTable table = makeBrdfTable(jobs);
        double rho = 0, total = 0;
        for (int i = 0; i < 256; ++i) {
            const float cosine = (float(i) + 0.5f) / 256;
            const vec2 split = table.lookUp(cosine, 1);
            const interop::EnvironmentWeights w = interop::environmentWeights(
                vec3(base), vec3(interop::kDielectricF0), split);
            rho += double(cosine * (w.diffuse.x + w.specular.x));
            total += double(cosine);
        }
        rho /= total;
        const float expected = emitted / float(1 - rho);
        for (const vec3& n : {vec3(0, 1, 0), vec3(1, 0, 0), vec3(0, 0, -1)})
            EXPECT_NEAR(sampleIrradiance(volume, vec3(0.3f, -0.2f, 0.5f), n).x, expected,
                        0.02f * expected)
                << base;
    }
}

// The light itself is the frame's: the probes hold what came by bounces. For a small light in the
// middle of a room the mean direct irradiance on the walls is I 4 pi / area, times pi / pi.
TEST(ProbeBake, APointLightCountsFromItsFirstBounce) {
    Scene scene;
    scene.paint(0, vec3(0.5f));
    scene.box(vec3(-2), vec3(2), 0, true);
    const PunctualLight lamp{.position = vec3(0), .intensity = vec3(10)};
    BakeLighting lighting;
    lighting.punctual = {&lamp, 1};
    ProbeBakeDesc desc;
    desc.spacing = 0.8f;
    desc.samples = 1024;
    const IrradianceVolume volume = scene.bake(lighting, desc);
    SerialJobs jobs;
    const vec2 split = makeBrdfTable(jobs).lookUp(0.7f, 1);
    const interop::EnvironmentWeights w = interop::environmentWeights(
        vec3(0.5f), vec3(interop::kDielectricF0), split);
    const float rho = w.diffuse.x + w.specular.x;
    const float direct = 4 * kPi * 10 / (6 * 16);  // mean over the walls
    float mean = 0;
    int count = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f})
            for (int i = 0; i < 64; ++i) {
                vec3 p(0), n(0);
                p[axis] = side * 2;
                p[(axis + 1) % 3] = -1.75f + 0.5f * float(i % 8);
                p[(axis + 2) % 3] = -1.75f + 0.5f * float(i / 8);
                n[axis] = -side;
                mean += sampleIrradiance(volume, p, n).x * kPi;
                ++count;
            }
    mean /= float(count);
    EXPECT_NEAR(mean, direct * rho / (1 - rho), 0.05f * direct * rho / (1 - rho));
}

// Of a plane without an end in the sun a ceiling gets E rho / pi, and nothing where a roof keeps
// the sun off.
TEST(ProbeBake, ASunlitFloorLightsWhatLooksDownOnIt) {
    for (const bool roofed : {false, true}) {
        Scene scene;
        scene.paint(0, vec3(0.5f));
        scene.box({-200, -1, -200}, {200, 0, 200}, 0);
        if (roofed) scene.box({-300, 20, -300}, {300, 21, 300}, 0);
        DirectionalLight sun{.direction = {0.6f, -0.8f, 0}, .illuminance = vec3(10)};
        BakeLighting lighting;
        lighting.directional = {&sun, 1};
        ProbeBakeDesc desc;
        desc.spacing = 1;
        desc.samples = 1024;
        desc.bounds = {vec3(-1, 0, -1), vec3(1, 2, 1)};
        const IrradianceVolume volume = scene.bake(lighting, desc);
        SerialJobs jobs;
        const vec2 split = makeBrdfTable(jobs).lookUp(0.7f, 1);
        const interop::EnvironmentWeights w = interop::environmentWeights(
            vec3(0.5f), vec3(interop::kDielectricF0), split);
        const float expected = roofed ? 0 : 10 * 0.8f * (w.diffuse.x + w.specular.x) / kPi;
        EXPECT_NEAR(sampleIrradiance(volume, vec3(0, 1, 0), vec3(0, -1, 0)).x, expected,
                    0.05f * expected + 1e-6f);
    }
}

TEST(ProbeBake, AThinWallKeepsTheLightOfTheNextRoomOut) {
    Scene scene;
    scene.paint(0, vec3(0.5f));
    scene.paint(1, vec3(0.5f), vec3(10));
    scene.box({-4, 0, -2}, {-0.05f, 3, 2}, 0, true);
    scene.box({0.05f, 0, -2}, {4, 3, 2}, 0, true);
    scene.box({-2.5f, 2.5f, -0.5f}, {-1.5f, 2.9f, 0.5f}, 1);
    ProbeBakeDesc desc;
    desc.spacing = 0.9f;
    const IrradianceVolume volume = scene.bake({}, desc);
    const auto meanIn = [&](float low, float high) {
        Random random(4);
        double sum = 0;
        for (int i = 0; i < 4000; ++i) {
            const float x = random.uniform(low, high), z = random.uniform(-1.99f, 1.99f);
            sum += double(meanOf(vec3(sampleIrradiance(volume, {x, 0, z}, {0, 1, 0}))));
            sum += double(meanOf(
                vec3(sampleIrradiance(volume, {x, random.uniform(0.01f, 2.99f), 2}, {0, 0, -1}))));
        }
        return sum / 8000;
    };
    const double lit = meanIn(-4, -0.06f), dark = meanIn(0.06f, 4), beside = meanIn(0.06f, 0.5f);
    EXPECT_GT(lit, 0.1);
    EXPECT_LT(dark, 0.003 * lit);
    EXPECT_LT(beside, 0.02 * lit);  // within half a metre of the wall
}

// Walls glow within; behind them lies a dark space, which no probe can tell from a room. Nearer to
// an edge than 0.13 of the spacing the frame's way to the eye helps, which is not asked here.
TEST(ProbeBake, ARoomIsAsLightInItsCornersAsElsewhere) {
    for (const float thickness : {0.1f, 0.3f}) {
        Scene scene;
        scene.paint(0, vec3(0), vec3(1));
        scene.paint(1, vec3(0));
        const vec3 half(2, 1.3f, 1.7f);
        scene.box(-half, half, 0, true);
        scene.box(-half - thickness, half + thickness, 1);
        scene.box(-half - 1.0f, half + 1.1f, 1, true);
        ProbeBakeDesc desc;
        desc.spacing = 0.6f;
        desc.samples = 256;
        const IrradianceVolume volume = scene.bake({}, desc);
        const float middle = sampleIrradiance(volume, {0, -half.y, 0}, {0, 1, 0}).x;
        EXPECT_NEAR(middle, 1, 0.1f);
        float least = 1e9f, most = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (const float side : {-1.0f, 1.0f})
                for (int i = 0; i < 50 * 50; ++i) {
                    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                    vec3 p(0), n(0);
                    n[axis] = -side;
                    p[axis] = side * half[axis];
                    p[u] = (half[u] - 0.08f) * (float(i % 50) / 24.5f - 1);
                    p[v] = (half[v] - 0.08f) * (float(i / 50) / 24.5f - 1);
                    const float light = sampleIrradiance(volume, p, n).x;
                    least = std::min(least, light);
                    most = std::max(most, light);
                }
        EXPECT_GT(least, 0.95f * middle) << thickness;
        EXPECT_LT(most, 1.05f * middle) << thickness;
    }
}

TEST(ProbeBake, ProbesInWallsMoveOutOrAreFilledFromTheirNeighbours) {
    Scene scene;
    scene.paint(0, vec3(0.5f));
    scene.box({-4, -1, -4}, {4, 0, 4}, 0);
    scene.box({-2.6f, 0, -2.6f}, {2.6f, 5, 2.6f}, 0);  // several cells thick
    BakeLighting lighting;
    lighting.ambientSky = lighting.ambientGround = vec3(1);
    ProbeBakeDesc desc;
    desc.spacing = 1;
    desc.bounds = {vec3(-4, 0, -4), vec3(4, 5, 4)};
    const IrradianceVolume volume = scene.bake(lighting, desc);
    uint32_t filled = 0, moved = 0;
    for (uint32_t i = 0; i < volume.grid.count(); ++i) {
        const IrradianceProbe p = volume.probe(i);
        EXPECT_GT(p.mean.x, 0.05f);
        if (p.weight < 0.5f)
            ++filled;
        else if (p.offset != vec3(0))
            ++moved;
        if (p.weight < 0.5f) continue;
        const vec3 at = volume.grid.position(i) + p.offset;
        EXPECT_FALSE(std::abs(at.x) < 2.6f && std::abs(at.z) < 2.6f && at.y < 5) << i;
    }
    EXPECT_EQ(filled, 4u * 4 * 5);
    EXPECT_GT(moved, 0u);
}

TEST(ProbeBake, IsTheSameForAnyNumberOfThreads) {
    Scene scene;
    scene.paint(0, vec3(0.5f));
    scene.paint(1, vec3(0.5f), vec3(3));
    scene.box(vec3(-2), vec3(2), 0, true);
    scene.box(vec3(-1), vec3(0), 1);
    const DirectionalLight sun;
    BakeLighting lighting;
    lighting.directional = {&sun, 1};
    ProbeBakeDesc desc;
    desc.spacing = 1;
    desc.samples = 32;
    const RayScene& rays = scene.build();
    std::vector<std::vector<std::byte>> files;
    for (const uint32_t threads : {1u, 2u, 8u}) {
        ThreadJobs jobs(threads);
        files.push_back(encodeIrradianceVolume(*bakeIrradiance(rays, lighting, desc, jobs)));
    }
    EXPECT_EQ(files[0], files[1]);
    EXPECT_EQ(files[0], files[2]);
}

TEST(ProbeBake, AnUpdaterReachesWhatABakeGives) {
    Scene scene;
    scene.paint(0, vec3(0.5f));
    scene.box(vec3(-2), vec3(2), 0, true);
    PunctualLight lamp{.position = vec3(1), .intensity = vec3(10)};
    BakeLighting lighting;
    ProbeBakeDesc desc;
    desc.spacing = 1.3f;
    const RayScene& rays = scene.build();
    SerialJobs jobs;
    IrradianceVolume dark = *bakeIrradiance(rays, lighting, desc, jobs);
    lighting.punctual = {&lamp, 1};
    const IrradianceVolume lit = *bakeIrradiance(rays, lighting, desc, jobs);
    const uint32_t probes = dark.grid.count();
    ProbeUpdater updater(rays, std::move(dark), jobs);
    for (uint32_t done = 0; done < probes; done += 5) {
        EXPECT_NE(updater.volume().lightHash, lit.lightHash);
        ASSERT_TRUE(updater.update(lighting, std::min(5u, probes - done), desc.samples));
    }
    EXPECT_EQ(updater.volume().lightHash, lit.lightHash);
    double reached = 0, baked = 0;
    for (uint32_t i = 0; i < probes; ++i) {
        reached += double(updater.volume().probe(i).mean.x);
        baked += double(lit.probe(i).mean.x);
        EXPECT_EQ(updater.volume().probe(i).offset, lit.probe(i).offset);
    }
    EXPECT_NEAR(reached, baked, 0.05 * baked);
    EXPECT_FALSE(updater.update(lighting, 1, 1));
    EXPECT_FALSE(updater.update(lighting, 1, 64, 0));
}

TEST(ProbeBake, RefusesWhatItCannotDo) {
    Scene scene;
    SerialJobs jobs;
    const RayScene& empty = scene.build();
    EXPECT_FALSE(bakeIrradiance(empty, {}, {}, jobs));
    scene.paint(0, vec3(0.5f));
    scene.box(vec3(-2), vec3(2), 0, true);
    const RayScene& rays = scene.build();
    ProbeBakeDesc desc;
    desc.spacing = 0.01f;
    EXPECT_FALSE(bakeIrradiance(rays, {}, desc, jobs));
    desc.spacing = std::nanf("");
    EXPECT_FALSE(bakeIrradiance(rays, {}, desc, jobs));
    desc.spacing = 2;
    desc.samples = 3;
    EXPECT_FALSE(bakeIrradiance(rays, {}, desc, jobs));
    desc.samples = 16;
    PunctualLight bad;
    bad.intensity.x = std::nanf("");
    BakeLighting lighting;
    lighting.punctual = {&bad, 1};
    EXPECT_FALSE(bakeIrradiance(rays, lighting, desc, jobs));
    EXPECT_TRUE(bakeIrradiance(rays, {}, desc, jobs));
}

}  // namespace
}  // namespace rushlight

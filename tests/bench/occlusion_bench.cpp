// What it costs to fill the occlusion buffer and to ask it.
#include "engine/jobs/tbb_jobs.h"
#include "renderer/geometry/view_math.h"
#include "renderer/visibility/occlusion/occlusion_buffer.h"
#include "tests/support/random.h"
#include "tests/support/scenes/shapes.h"

#include <benchmark/benchmark.h>

#include <algorithm>

namespace rushlight {
namespace {

constexpr uint32_t kWidth = 1280, kHeight = 720;

/// Boxes and spheres of 12 to 480 triangles before the camera, near ones first: 5,592 triangles in
/// 30 of them.
struct World {
    std::vector<OccluderMesh> meshes;
    std::vector<Occluder> occluders;
    std::vector<OcclusionBox> boxes;
    mat4 clipFromWorld = reversedPerspective(1.0f, 0.5625f, 0.1f, 0);
    uint32_t triangles = 0;

    World(uint32_t count, float size, float boxSize) {
        Random random(11);
        for (const Shape& shape :
             {makeCube(), makeSphere(4, 8), makeSphere(10, 10), makeSphere(16, 16)})
            meshes.push_back(makeOccluderMesh(shape.positions, shape.indices));
        for (uint32_t i = 0; i < count; ++i) {
            const float depth = 4 + 36 * float(i) / float(count);
            mat4x3 transform(size * random.uniform(0.5f, 1.5f));
            transform[3] = {random.uniform(-1, 1) * depth, random.uniform(-0.6f, 0.6f) * depth,
                            -depth};
            const OccluderMesh& mesh = meshes[random.below(uint32_t(meshes.size()))];
            triangles += mesh.triangleCount();
            occluders.push_back({&mesh, transform, false});
        }
        for (uint32_t i = 0; i < 3000; ++i) {
            const float depth = random.uniform(5, 80);
            boxes.push_back(
                {{random.uniform(-1, 1) * depth, random.uniform(-0.6f, 0.6f) * depth, -depth},
                 random.vector(0.5f, 1) * boxSize});
        }
    }
    void fill(OcclusionBuffer& buffer, JobSystem& jobs) const {
        buffer.begin(kWidth, kHeight, clipFromWorld);
        for (const Occluder& occluder : occluders) buffer.addOccluder(occluder);
        buffer.rasterize(jobs);
    }
};

// Arguments: occluders, their half size in millimetres, threads.
void fillBuffer(benchmark::State& state) {
    const World world(uint32_t(state.range(0)), float(state.range(1)) / 1000, 1);
    const auto jobs = createTbbJobs(uint32_t(state.range(2)));
    OcclusionBuffer buffer;
    for (auto _ : state) world.fill(buffer, *jobs);
    state.counters["triangles"] = world.triangles;
    state.counters["filled"] = buffer.triangleCount();
    state.counters["triangles/s"] = benchmark::Counter(
        double(world.triangles), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(fillBuffer)
    ->ArgNames({"occluders", "half_mm", "threads"})
    ->ArgsProduct({{30, 100, 400}, {300, 1000, 3000}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

// Arguments: half size of the boxes in millimetres; whether they are asked one by one.
void testBoxes(benchmark::State& state) {
    const World world(100, 1, float(state.range(0)) / 1000);
    SerialJobs jobs;
    OcclusionBuffer buffer;
    world.fill(buffer, jobs);
    std::vector<uint8_t> visible(world.boxes.size());
    for (auto _ : state) {
        if (state.range(1))
            for (size_t i = 0; i < world.boxes.size(); ++i)
                visible[i] = buffer.isVisible(world.boxes[i].center, world.boxes[i].halfExtent);
        else
            buffer.test(world.boxes, visible.data());
        benchmark::DoNotOptimize(visible.data());
    }
    state.counters["hidden"] = double(std::count(visible.begin(), visible.end(), 0));
    state.counters["per box"] = benchmark::Counter(
        double(world.boxes.size()),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(testBoxes)
    ->ArgNames({"half_mm", "single"})
    ->ArgsProduct({{100, 500, 2000}, {0, 1}})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace rushlight

BENCHMARK_MAIN();

// The parts of a frame that are paid for by the object: boxes against a frustum, sorting and
// recording draws, executing them on the null device and in OpenGL.
#include "engine/jobs/tbb_jobs.h"
#include "renderer/backend/null/null_device.h"
#include "renderer/visibility/spatial_index.h"
#include "renderer/visibility/visibility.h"
#include "tests/bench/bench_world.h"
#include "tests/support/gl/test_context.h"

#include <benchmark/benchmark.h>

namespace rushlight {
namespace {

Aabb randomBox(Random& random) {
    const vec3 center = random.vector(-100, 100);
    return {center - 0.5f, center + 0.5f};
}

CullVolume someView() {
    View view;
    view.viewFromWorld = glm::lookAt(vec3(0), vec3(1, 0.2f, 0.3f), vec3(0, 1, 0));
    view.farPlane = 80;
    CullVolume volume;
    volume.add(makeCamera(view, 1.8f).value().frustum);
    return volume;
}

// Every box against six planes: no hierarchy. Argument: boxes; a million are streamed from memory.
void cullBoxes(benchmark::State& state) {
    Random random(1);
    std::vector<BoxBlock> blocks(size_t(state.range(0)) / kBlockSize);
    for (BoxBlock& block : blocks)
        for (uint32_t i = 0; i < kBlockSize; ++i) block.set(i, randomBox(random));
    const CullVolume volume = someView();
    for (auto _ : state)
        for (const BoxBlock& block : blocks) benchmark::DoNotOptimize(touchingBoxes(block, volume));
    const double boxes = double(blocks.size() * kBlockSize);
    state.counters["ns/box"] = benchmark::Counter(
        boxes * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(cullBoxes)->Arg(1 << 12)->Arg(1'000'000);

/// A world whose objects are all in one list, made once.
struct SortedDraws {
    std::unique_ptr<Device> device = createNullDevice();
    SerialJobs serial;
    GeometryStore geometry{*device};
    TextureStore textures{*device, serial};
    MaterialStore materials{*device, textures};
    InstanceWorld world;
    FrameWorlds worlds{{nullptr, &world}};
    std::vector<VisibleItem> items;
    DrawList list;
    CommandBuffer commands;

    explicit SortedDraws(uint32_t count) {
        Random random(2);
        std::vector<MeshHandle> meshes;
        for (uint32_t i = 0; i < count; ++i)
            meshes.push_back(geometry.create(makeCube().desc()).value());
        std::vector<Instance> instances(count);
        for (uint32_t i = 0; i < count; ++i) {
            instances[i].mesh = meshes[i];
            instances[i].worldFromLocal[3] = random.vector(-50, 50);
        }
        if (!materials.flush(*textures.flush())) std::abort();
        world.assign(instances, serial);
        world.prepare(geometry, materials, {}, serial);
        for (uint32_t i = 0; i < count; ++i) {
            const InstanceRecord& r = world.record(i);
            const float depth = 60 + r.center().z;
            items.push_back({opaqueKey(r.surfaceFlags, r.textureSet, r.mesh.index(), 0, depth),
                             FrameWorlds::object(1, i), r.surfaceFlags, 0});
        }
    }
    void record(JobSystem& jobs) {
        list.items = items;
        list.arrange(worlds, geometry, {});
        commands.clear();
        list.allocate(commands);
        jobs.forRanges(
            uint32_t(items.size()), DrawList::kItemsPerJob,
            [&](uint32_t begin, uint32_t end) { list.fill(commands, worlds, begin, end); });
        DrawBinder{&geometry, &materials}.record(commands, list);
    }
};

// Unique draws, each with a transform, a material and a depth: sorted, batched, written, recorded.
// Arguments: draws, threads.
void sortAndRecord(benchmark::State& state) {
    SortedDraws draws(uint32_t(state.range(0)));
    const auto jobs = createTbbJobs(uint32_t(state.range(1)));
    for (auto _ : state) draws.record(*jobs);
    state.counters["ns/draw"] = benchmark::Counter(
        double(state.range(0)) * 1e-9,
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(sortAndRecord)
    ->ArgNames({"draws", "threads"})
    ->ArgsProduct({{3000, 30000}, {1, 2}})
    ->UseRealTime();

// What the backend takes to submit a frame of unique draws. Argument: 0 the null device, 1 OpenGL.
void executeDraws(benchmark::State& state) {
    const TestContext context;
    BenchWorld::Desc desc;
    if (state.range(0)) desc.loadGl = TestContext::load;
    if (state.range(0) && !context.valid()) return state.SkipWithError("no OpenGL 4.5 context");
    BenchWorld world(desc);
    for (int i = 0; i < 3; ++i) world.frame();
    for (auto _ : state) {
        world.frame();
        state.SetIterationTime(world.report().cpuExecuteMs / 1000);
    }
    state.counters["draws"] = world.report().draws;
    state.counters["ns/draw"] = benchmark::Counter(
        double(world.report().draws) * 1e-9,
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(executeDraws)
    ->ArgName("gl")
    ->Arg(0)
    ->Arg(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

// Bytes that a world holds for each of its objects.
void memoryPerObject(benchmark::State& state) {
    SortedDraws draws(1000);
    const uint32_t count = uint32_t(state.range(0));
    std::vector<Instance> instances(count);
    Random random(3);
    for (Instance& instance : instances) {
        instance.mesh = MeshHandle::make(random.below(1000), 1);
        instance.worldFromLocal[3] = random.vector(-500, 500);
    }
    for (auto _ : state) {
        InstanceWorld world;
        for (const Instance& instance : instances) world.add(instance);
        world.prepare(draws.geometry, draws.materials, {}, draws.serial);
        state.counters["bytes/object"] = double(world.bytes()) / double(count);
    }
}
BENCHMARK(memoryPerObject)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rushlight

BENCHMARK_MAIN();

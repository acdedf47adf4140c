// What building a frame costs: a camera and four cascades, culled, detailed, sorted and recorded,
// on the null backend.
#include "engine/jobs/tbb_jobs.h"
#include "tests/bench/bench_world.h"

#include <benchmark/benchmark.h>

#include <memory>

namespace rushlight {
namespace {

// Arguments: objects, percent that move, threads, whether what is hidden is culled too.
void buildFrame(benchmark::State& state) {
    const auto jobs = createTbbJobs(uint32_t(state.range(2)));
    BenchWorld::Desc desc;
    desc.objects = uint32_t(state.range(0));
    desc.meshes = std::min(desc.objects, 3000u);
    desc.movingPercent = uint32_t(state.range(1));
    desc.jobs = jobs.get();
    BenchWorld world(desc);
    world.settings.occlusionCulling = state.range(3);
    for (int i = 0; i < 5; ++i) world.frame();
    for (auto _ : state) {
        world.frame();
        state.SetIterationTime(world.report().cpuBuildMs / 1000);
    }
    state.counters["visible"] = world.report().visible;
    state.counters["draws"] = world.report().draws;
}
BENCHMARK(buildFrame)
    ->ArgNames({"objects", "moving%", "threads", "occlusion"})
    ->ArgsProduct({{300, 3000, 30000, 300000, 1000000}, {0, 10}, {1, 2}, {0, 1}})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rushlight

BENCHMARK_MAIN();

// 64 to 4,096 lights on one level, whose ranges shrink as they grow in number so that a pixel is
// lit by as many: what building their lists costs, and the lighting pass.
#include "engine/jobs/tbb_jobs.h"
#include "renderer/lighting/clusters/light_clusters.h"
#include "renderer/renderer.h"
#include "tests/support/gl/test_context.h"
#include "tests/support/random.h"
#include "tests/support/scenes/shapes.h"

#include <benchmark/benchmark.h>

#include <algorithm>

namespace rushlight {
namespace {

constexpr uint32_t kWidth = 1280, kHeight = 720;
constexpr float kSide = 60;  // metres of the level's side
constexpr float kLightsOfAPoint = 6;

std::vector<PunctualLight> lightsOf(uint32_t count) {
    Random random(5);
    const float range = std::sqrt(kLightsOfAPoint * kSide * kSide / (kPi * float(count)));
    std::vector<PunctualLight> lights(count);
    for (PunctualLight& light : lights) {
        light.position = {random.uniform(-kSide / 2, kSide / 2), range * 0.3f,
                          random.uniform(-kSide / 2, kSide / 2)};
        light.range = range;
        light.intensity = vec3(0.2f * range * range);
        if (random.below(3)) continue;
        light.outerConeAngle = 0.6f;
        light.direction = glm::normalize(vec3(0.3f, -1, 0.2f));
    }
    return lights;
}

View viewOfLevel() {
    View view;
    view.viewFromWorld = glm::lookAt(vec3(0, 12, 38), vec3(0, 0, 4), vec3(0, 1, 0));
    return view;
}

// Arguments: lights, threads.
void buildClusters(benchmark::State& state) {
    const auto jobs = createTbbJobs(uint32_t(state.range(1)));
    const std::vector<PunctualLight> lights = lightsOf(uint32_t(state.range(0)));
    const CameraMatrices camera = makeCamera(viewOfLevel(), float(kWidth) / kHeight).value();
    LightClusters clusters;
    for (auto _ : state) clusters.build(camera, kWidth, kHeight, {lights, {}, {}}, *jobs);
    state.counters["references"] = double(clusters.indices.size());
    state.counters["froxels"] = double(clusters.clusters.size());
}
BENCHMARK(buildClusters)
    ->ArgNames({"lights", "threads"})
    ->ArgsProduct({{64, 256, 1024, 4096}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// The GPU time of the lighting pass. Argument: lights; 0: none.
void lightingPass(benchmark::State& state) {
    const TestContext context;
    const auto jobs = createTbbJobs(2);
    RendererDesc desc;
    desc.loadGl = TestContext::load;
    desc.jobs = jobs.get();
    const auto renderer = std::move(Renderer::create(desc).value());
    const MeshHandle cube = renderer->createMesh(makeCube().desc("cube")).value();
    std::vector<Instance> instances(1);
    instances[0].mesh = cube;
    instances[0].worldFromLocal = mat4x3(mat4(glm::translate(mat4(1), vec3(0, -1, 0)) *
                                              glm::scale(mat4(1), vec3(kSide / 2, 1, kSide / 2))));
    const std::vector<PunctualLight> lights = lightsOf(uint32_t(state.range(0)));
    FrameInput input;
    input.view = viewOfLevel();
    input.instances = instances;
    input.lighting.punctual = lights;
    input.settings.bloom = false;
    CapturedImage image;
    std::vector<double> times;
    for (auto _ : state) {
        const auto ticket = renderer->renderOffscreen(input, kWidth, kHeight, CaptureKind::display);
        if (!ticket || !renderer->takeCapture(*ticket, true, image)) std::abort();
        double time = 0;  // of an earlier frame; none in the first
        for (const PassReport& pass : renderer->report().passes)
            if (std::string_view(pass.name) == "lighting") time = pass.gpuMs;
        if (time > 0) times.push_back(time);
        state.SetIterationTime(time / 1000);
    }
    state.counters["least_ms"] = *std::ranges::min_element(times);
}
BENCHMARK(lightingPass)
    ->ArgName("lights")
    ->Arg(0)
    ->Arg(64)
    ->Arg(256)
    ->Arg(1024)
    ->Arg(4096)
    ->Iterations(15)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rushlight

BENCHMARK_MAIN();

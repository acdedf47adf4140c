#include "sandbox/tool/command.h"
#include "sandbox/tool/frame_runner.h"
#include "sandbox/tool/options.h"
#include "sandbox/tool/progress.h"
#include "sandbox/tool/trace_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace rushlight::tool {
namespace {

struct BenchArguments {
    RenderOptions render;
    uint32_t frames = 30;
    std::string json;
    std::string trace;
    bool redrawShadows = false;
};

/// One measured frame.
struct Sample {
    FrameReport report;
    FrameTimes times;
};

double middle(std::vector<double> values) {
    if (values.empty()) return 0;
    std::ranges::sort(values);
    const size_t half = values.size() / 2;
    return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

template <class Get>
double medianOf(const std::vector<Sample>& samples, Get get) {
    std::vector<double> values;
    for (const Sample& sample : samples) values.push_back(get(sample));
    return middle(std::move(values));
}

/// The last frame's counters with the medians of all frames' times.
Sample medians(const std::vector<Sample>& samples) {
    Sample result = samples.back();
    FrameReport& report = result.report;
    report.cpuBuildMs = medianOf(samples, [](const Sample& s) { return s.report.cpuBuildMs; });
    report.cpuExecuteMs = medianOf(samples, [](const Sample& s) { return s.report.cpuExecuteMs; });
    report.gpuMs = medianOf(samples, [](const Sample& s) { return s.report.gpuMs; });
    result.times.wallMs = medianOf(samples, [](const Sample& s) { return s.times.wallMs; });
    for (size_t p = 0; p < report.passes.size(); ++p) {
        std::vector<double> cpu;
        std::vector<double> gpu;
        for (const Sample& sample : samples) {
            // A pass that is only drawn now and then (a cached shadow) sits at another place.
            const auto same = std::ranges::find_if(
                sample.report.passes, [&](const PassReport& pass) {
                    return std::string_view(pass.name) == report.passes[p].name;
                });
            if (same == sample.report.passes.end()) continue;
            cpu.push_back(same->cpuMs);
            gpu.push_back(same->gpuMs);
        }
        report.passes[p].cpuMs = middle(std::move(cpu));
        report.passes[p].gpuMs = middle(std::move(gpu));
    }
    return result;
}

nlohmann::ordered_json wallJson(const std::vector<Sample>& samples) {
    std::vector<double> wall;
    for (const Sample& sample : samples) wall.push_back(sample.times.wallMs);
    std::ranges::sort(wall);
    return {{"frames", wall.size()},
            {"wall_min_ms", wall.front()},
            {"wall_median_ms", middle(wall)},
            {"wall_p90_ms", wall[(wall.size() - 1) * 9 / 10]},
            {"wall_max_ms", wall.back()}};
}

void printSummary(const RenderSetup& setup, const Sample& sample, const std::vector<Sample>& all) {
    const FrameReport& r = sample.report;
    const auto wall = wallJson(all);
    std::printf("context %s, %u threads, %zu frames\n", toText(setup.contextKind()),
                setup.threads(), all.size());
    std::printf("frame   median %.2f ms, lowest %.2f, highest %.2f\n", sample.times.wallMs,
                wall["wall_min_ms"].get<double>(), wall["wall_max_ms"].get<double>());
    std::printf("build   %.3f ms, execute %.3f ms, gpu %.2f ms\n", r.cpuBuildMs, r.cpuExecuteMs,
                r.gpuMs);
    std::printf("drawn   %u of %u instances, %u draws, %llu triangles, %llu allocations\n",
                r.visible, r.instances, r.draws, static_cast<unsigned long long>(r.triangles),
                static_cast<unsigned long long>(sample.times.allocations));
    for (const PassReport& pass : r.passes)
        std::printf("  %-16s %8.2f ms gpu %8.3f ms cpu %6u draws %10llu triangles\n", pass.name,
                    pass.gpuMs, pass.cpuMs, pass.draws,
                    static_cast<unsigned long long>(pass.triangles));
}

Result<Sample> measure(RenderSetup& setup, const BenchArguments& arguments) {
    FrameInput input = setup.frame();
    if (arguments.redrawShadows) input.settings.shadowCaching = false;
    Sample sample;
    const auto image = renderFrame(setup, input, arguments.render.size, CaptureKind::display, {},
                                   sample.times);
    if (!image) return tl::unexpected(image.error());
    sample.report = setup.renderer().report();
    return sample;
}

/// What all frames gave.
struct Samples {
    double firstFrameMs = 0;
    std::vector<Sample> measured;
};

Result<void> measureAll(RenderSetup& setup, const BenchArguments& arguments, TraceFile& trace,
                        Samples& samples) {
    const uint32_t warmup = std::max(arguments.render.warmup, 1u);
    const Progress progress("frame");
    for (uint32_t i = 0; i < warmup + arguments.frames; ++i) {
        auto sample = measure(setup, arguments);
        if (!sample) return tl::unexpected(sample.error());
        trace.add(sample->report, sample->times, i < warmup);
        if (i == 0) samples.firstFrameMs = sample->times.wallMs;
        if (i >= warmup) samples.measured.push_back(std::move(*sample));
        progress.show(i + 1, warmup + arguments.frames);
    }
    return {};
}

Result<int> bench(const BenchArguments& arguments) {
    TraceFile trace(arguments.trace);
    if (auto checked = trace.check(); !checked) return tl::unexpected(checked.error());
    auto setup = RenderSetup::open(arguments.render, true);
    if (!setup) return tl::unexpected(setup.error());
    Samples samples;
    auto drawn = trace.finish(measureAll(**setup, arguments, trace, samples), **setup);
    if (!drawn) return tl::unexpected(drawn.error());
    const Sample result = medians(samples.measured);
    printSummary(**setup, result, samples.measured);
    auto json = statsJson(**setup, arguments.render.size, samples.firstFrameMs, result.report,
                          result.times);
    json["bench"] = wallJson(samples.measured);
    for (const std::string& path : {arguments.json, arguments.render.stats})
        if (!path.empty())
            if (auto written = writeJson(path, json); !written)
                return tl::unexpected(written.error());
    return kSuccess;
}

}  // namespace

void addBench(CLI::App& app, Action& action) {
    auto arguments = std::make_shared<BenchArguments>();
    arguments->render.warmup = 5;
    CLI::App* command = app.add_subcommand(
        "bench", "Measure frames: medians per stage and pass, and counters");
    addRenderOptions(*command, arguments->render);
    command->add_option("--frames", arguments->frames, "Frames to measure, after --warmup (5)")
        ->check(CLI::Range(1u, 1000000u))
        ->capture_default_str();
    command->add_option("--json", arguments->json, "Write the numbers as JSON");
    addTraceOption(*command, arguments->trace);
    command->add_flag("--redraw-shadows", arguments->redrawShadows,
                      "Draw every shadow map in every frame");
    command->callback([&action, arguments] { action = [arguments] { return bench(*arguments); }; });
}

}  // namespace rushlight::tool

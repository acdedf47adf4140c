#include "renderer/capture/breakdown/breakdown.h"
#include "sandbox/tool/command.h"
#include "sandbox/tool/frame_runner.h"
#include "sandbox/tool/options.h"
#include "sandbox/tool/progress.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <optional>

namespace rushlight::tool {
namespace {

struct BreakdownArguments {
    RenderOptions render;
    std::string output;
    std::string compare;
};

Result<int> breakdown(const BreakdownArguments& arguments) {
    std::optional<WrittenBreakdown> other;
    if (!arguments.compare.empty()) {
        auto loaded = loadBreakdown(arguments.compare);
        if (!loaded) return tl::unexpected(loaded.error());
        other = std::move(*loaded);
    }
    auto setup = RenderSetup::open(arguments.render, false);
    if (!setup) return tl::unexpected(setup.error());
    FrameTimes times;
    double firstFrameMs = -1;
    const uvec2 size = arguments.render.size;
    const FrameInput input = (*setup)->frame();
    for (uint32_t i = 0; i < arguments.render.warmup + 2; ++i) {  // the last one's times are of a
                                                                  // warm frame
        if (auto image = renderFrame(**setup, input, size, CaptureKind::display, {}, times); !image)
            return tl::unexpected(image.error());
        if (firstFrameMs < 0) firstFrameMs = times.wallMs;
    }
    const Progress progress("frame");
    auto taken = takeBreakdown(
        (*setup)->renderer(), input,
        {size.x, size.y, [&](uint32_t done, uint32_t count) { progress.show(done, count); }});
    if (!taken) return tl::unexpected(taken.error());
    taken->title = std::filesystem::path(arguments.render.scene).filename().string();
    const nlohmann::ordered_json stats = statsJson(**setup, size, firstFrameMs, taken->report,
                                                   times);
    taken->host = stats.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    if (auto ok = writeBreakdown(arguments.output, *taken, other ? &*other : nullptr); !ok)
        return tl::unexpected(ok.error());
    if (!arguments.render.stats.empty())
        if (auto ok = writeJson(arguments.render.stats, stats); !ok)
            return tl::unexpected(ok.error());
    return kSuccess;
}

}  // namespace

void addBreakdown(CLI::App& app, Action& action) {
    auto arguments = std::make_shared<BreakdownArguments>();
    CLI::App* command = app.add_subcommand(
        "breakdown",
        "Take a frame apart: a page with every pass, its pictures, costs and commands");
    addRenderOptions(*command, arguments->render);
    command
        ->add_option("-o,--output", arguments->output,
                     "The folder: index.html (all in one file), frame.json, commands.txt, pictures")
        ->required();
    command->add_option("--compare", arguments->compare,
                        "frame.json of another breakdown: shows both, passes that differ first");
    command->callback(
        [&action, arguments] { action = [arguments] { return breakdown(*arguments); }; });
}

}  // namespace rushlight::tool

#include "renderer/capture/write_file.h"
#include "sandbox/tool/command.h"
#include "sandbox/tool/options.h"
#include "sandbox/tool/probes.h"
#include "sandbox/tool/render_setup.h"

#include <chrono>
#include <cstdio>
#include <memory>

namespace rushlight::tool {
namespace {

struct BakeArguments {
    RenderOptions render;
    std::string output;
};

Result<int> bake(const BakeArguments& arguments) {
    RenderOptions options = arguments.render;
    options.probes = "off";
    const auto setup = RenderSetup::openToBake(options);
    if (!setup) return tl::unexpected(setup.error());
    const auto start = std::chrono::steady_clock::now();
    const auto volume = (*setup)->bakeProbes();
    if (!volume) return tl::unexpected(volume.error());
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    const std::string path = arguments.output.empty() ? defaultProbePath(options.scene)
                                                      : arguments.output;
    if (auto written = writeFile(path, encodeIrradianceVolume(*volume)); !written)
        return tl::unexpected(written.error());
    const ProbeGrid& g = volume->grid;
    std::printf("%s: %u x %u x %u probes every %.2f x %.2f x %.2f m, in %.1f s\n", path.c_str(),
                g.counts.x, g.counts.y, g.counts.z, double(g.spacing.x), double(g.spacing.y),
                double(g.spacing.z), elapsed.count());
    return kSuccess;
}

}  // namespace

void addBake(CLI::App& app, Action& action) {
    auto arguments = std::make_shared<BakeArguments>();
    CLI::App* command = app.add_subcommand(
        "bake", "Trace the indirect light of a scene and store it beside it; needs no OpenGL");
    addBakeOptions(*command, arguments->render);
    command->add_option("-o,--output", arguments->output,
                        "The file to write (SCENE with the extension .probes)");
    command->callback([&action, arguments] { action = [arguments] { return bake(*arguments); }; });
}

}  // namespace rushlight::tool

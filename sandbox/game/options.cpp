#include "sandbox/game/options.h"

#include "renderer/frame/quality.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <map>
#include <string>

namespace rushlight {
namespace {

constexpr uint32_t kMaxSide = 16384;    // pixels
constexpr float kDuskExposure = 1.35f;  // shade is readable, the lamps keep their colour

/// "1280x720"
std::string readSize(const std::string& text, ViewerOptions& options) {
    unsigned width = 0;
    unsigned height = 0;
    char rest = 0;
    const int read = std::sscanf(text.c_str(), "%ux%u%c", &width, &height, &rest);
    if (read != 2 || width < 1 || height < 1 || width > kMaxSide || height > kMaxSide)
        return "'" + text + "' is no size; write WIDTHxHEIGHT, each from 1 to " +
               std::to_string(kMaxSide) + ".";
    options.width = width;
    options.height = height;
    return {};
}

void setQuality(FrameSettings& settings, Quality quality) {
    const ToneMap toneMap = settings.toneMap;
    const float exposureScale = settings.exposureScale;
    settings = frameSettings(quality);
    settings.lightShadows = quality != Quality::low;  // the lamps' are what there is to see
    settings.toneMap = toneMap;
    settings.exposureScale = exposureScale;
}

void addViewOptions(CLI::App& app, ViewerOptions& viewer) {
    app.add_option_function<std::string>(
           "--size",
           [&viewer](const std::string& text) {
               if (auto problem = readSize(text, viewer); !problem.empty())
                   throw CLI::ValidationError("--size", problem);
           },
           "size of the window in pixels, WIDTHxHEIGHT")
        ->default_str("1280x720");
    app.add_option("--vsync", viewer.verticalSync, "on or off: wait for the display")
        ->transform(
            CLI::CheckedTransformer(std::map<std::string, bool>{{"on", true}, {"off", false}}))
        ->default_str("on");
    const std::map<std::string, Quality> qualities{{"low", Quality::low},
                                                   {"medium", Quality::medium},
                                                   {"high", Quality::high},
                                                   {"ultra", Quality::ultra}};
    app.add_option_function<Quality>(
           "--quality", [&viewer](Quality quality) { setQuality(viewer.settings, quality); },
           "low, medium, high or ultra: what a frame may cost; the lamps cast shadows from medium "
           "on")
        ->transform(CLI::CheckedTransformer(qualities))
        ->default_str("medium");
    const std::map<std::string, ToneMap> toneMaps{{"none", ToneMap::none},
                                                  {"neutral", ToneMap::neutral},
                                                  {"agx", ToneMap::agx},
                                                  {"aces", ToneMap::aces}};
    app.add_option("--tonemap", viewer.settings.toneMap, "none, neutral, agx or aces")
        ->transform(CLI::CheckedTransformer(toneMaps))
        ->default_str("neutral");
    app.add_option("--exposure-scale", viewer.settings.exposureScale,
                   "linear factor on radiance (1.35)")
        ->check(CLI::PositiveNumber);
    app.add_option("--environment", viewer.environment,
                   "panorama (.hdr, .exr) that lights the level and is its sky; default: "
                   "content/square/dusk.hdr of the program")
        ->check(CLI::ExistingFile);
    app.add_option("--shaders", viewer.shaderDirectory,
                   "folder to read shaders from, and to watch for changes")
        ->check(CLI::ExistingDirectory);
    app.add_flag("--overlay", viewer.showOverlay, "begin with the panels open (Tab)");
    app.add_flag(
        "--fly", [&viewer](int64_t) { viewer.cameraMode = CameraMode::fly; },
        "begin flying instead of walking (F)");
    app.add_option("--camera", viewer.camera,
                   "name or index of a camera of the level to begin at, instead of its spawn");
}

void addTestOptions(CLI::App& app, ViewerOptions& viewer) {
    app.add_option("--frames", viewer.frames,
                   "end after so many frames of 1/60 s each, whatever time they take");
    app.add_option("--screenshot", viewer.screenshot,
                   "write the last frame's picture (.png, .jpg) and end; without --frames or a "
                   "script after one frame");
    auto* script = app.add_option(
        "--script", viewer.script,
        "play keys and mouse from a file: lines 'FRAME press|release|tap "
        "KEY', 'FRAME look X Y', 'FRAME turn FRAMES X Y', 'FRAME scroll N'");
    app.add_flag("--walk-demo", viewer.walkDemo, "play the built-in script: once around the square")
        ->excludes(script);
}

}  // namespace

std::optional<SandboxOptions> parseOptions(int argc, char** argv, int& exitCode) {
    SandboxOptions options;
    options.viewer.program = "sandbox";
    options.viewer.title = "Rushlight: dusk in the square";
    options.viewer.cameraMode = CameraMode::walk;
    options.viewer.settings.exposureScale = kDuskExposure;
    setQuality(options.viewer.settings, Quality::medium);
    CLI::App app("Walk through a square at dusk and light its lamps. Tab shows all keys.",
                 "sandbox");
    app.add_option("--level", options.viewer.scene,
                   "glTF or GLB file; default: content/square/square.gltf of the program");
    app.add_flag("--lit", options.allLit, "all lamps burn from the start");
    addViewOptions(app, options.viewer);
    addTestOptions(app, options.viewer);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const bool asked = error.get_exit_code() == 0;
        exitCode = asked ? app.exit(error) : 2;
        if (!asked)
            std::fprintf(stderr, "sandbox: error: command line: %s See sandbox --help.\n",
                         error.what());
        return std::nullopt;
    }
    return options;
}

}  // namespace rushlight

#include "sandbox/tool/command.h"
#include "sandbox/tool/options.h"
#include "sandbox/viewer/viewer.h"

#include <memory>

namespace rushlight::tool {
namespace {

struct ViewArguments {
    RenderOptions render;
    bool verticalSync = true;
    bool walk = false;
    uint32_t frames = 0;
    std::string screenshot;
};

ViewerOptions viewerOptions(const ViewArguments& arguments) {
    const RenderOptions& render = arguments.render;
    ViewerOptions options;
    options.title = "Rushlight: " + render.scene;
    options.scene = render.scene;
    options.width = render.size.x;
    options.height = render.size.y;
    options.verticalSync = arguments.verticalSync;
    options.cameraMode = arguments.walk ? CameraMode::walk : CameraMode::fly;
    options.camera = render.camera;
    options.eye = render.eye;
    options.target = render.target;
    if (render.eye) options.verticalFov = glm::radians(render.verticalFov);
    options.environment = render.environment;
    options.reflectionProbes = render.reflectionProbes;
    options.lighting.environmentRotation = glm::radians(render.environmentRotation);
    options.lighting.environmentIntensity = render.environmentIntensity;
    const vec3 plain(render.environment.empty() ? 0.3f : 0.0f);
    options.lighting.ambientSky = render.ambient.value_or(plain);
    options.lighting.ambientGround = render.ambient.value_or(0.5f * plain);
    options.lighting.background = render.background.value_or(
        render.environment.empty() ? Background::color : Background::environment);
    options.lighting.backgroundColor = render.backgroundColor;
    options.settings = settingsFrom(render);
    options.pinRasterThreads = true;
    options.frames = arguments.frames;
    options.screenshot = arguments.screenshot;
    return options;
}

}  // namespace

void addView(CLI::App& app, Action& action) {
    auto arguments = std::make_shared<ViewArguments>();
    CLI::App* command = app.add_subcommand("view",
                                           "A window to fly through a scene; Tab shows how");
    addRenderOptions(*command, arguments->render);
    // What only makes sense for pictures without a player is not taken, rather than ignored.
    for (const char* name :
         {"--time", "--animation", "--context", "--threads", "--warmup", "--strict", "--stats"})
        command->remove_option(command->get_option(name));
    command->add_option("--frames", arguments->frames,
                        "End after so many frames; 0: run until closed");
    command->add_option("--screenshot", arguments->screenshot,
                        "Write the last frame's picture and end");
    command->add_flag("--walk", arguments->walk, "Begin walking instead of flying");
    command->add_flag("!--no-vsync", arguments->verticalSync, "Do not wait for the display");
    command->callback([&action, arguments] {
        action = [arguments]() -> Result<int> { return runViewer(viewerOptions(*arguments)); };
    });
}

}  // namespace rushlight::tool

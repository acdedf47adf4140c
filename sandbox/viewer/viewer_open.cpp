#include "engine/jobs/tbb_jobs.h"
#include "renderer/capture/image_files.h"
#include "sandbox/viewer/program_files.h"
#include "sandbox/viewer/viewer_app.h"

#include <cstdio>
#include <vector>

namespace rushlight {
namespace {

constexpr float kGroundReach = 50;  // metres below a camera in which ground is looked for

void writeLog(void* user, LogLevel level, std::string_view message) {
    if (level < LogLevel::warning) return;
    const auto& options = *static_cast<const ViewerOptions*>(user);
    std::fprintf(stderr, "%s: %s: %.*s\n", options.program.c_str(),
                 level == LogLevel::error ? "error" : "warning", int(message.size()),
                 message.data());
}

}  // namespace

Result<void> ViewerApp::open() {
    for (const auto step :
         {&ViewerApp::openScript, &ViewerApp::openWindow, &ViewerApp::openRenderer,
          &ViewerApp::openEnvironment, &ViewerApp::openLevel})
        if (auto done = (this->*step)(); !done) return done;
    if (options_.frames) {
        lastFrame_ = options_.frames;
    } else if (!options_.screenshot.empty()) {
        lastFrame_ = script_ ? script_->lastFrame() + 1 : 1;
    }
    settings_.frame = options_.settings;
    if (auto lit = useLevelLight(); !lit) return lit;
    panelsOpen_ = options_.showOverlay;
    if (game_ && !isScripted() && !lastFrame_) windowInput_->captureMouse(!panelsOpen_);
    return placeCamera();
}

Result<void> ViewerApp::openScript() {
    if (options_.script.empty() && !options_.walkDemo) return {};
    auto script = options_.script.empty() ? InputScript::parse("walk demo", kWalkDemo)
                                          : InputScript::load(options_.script);
    if (!script) return tl::unexpected(script.error());
    script_ = std::move(*script);
    input_ = &scripted_;
    return {};
}

Result<void> ViewerApp::openWindow() {
    WindowOptions options;
    options.title = options_.title;
    options.width = options_.width;
    options.height = options_.height;
    options.verticalSync = options_.verticalSync;
    options.context.pinRasterThreads = options_.pinRasterThreads;
    auto window = createWindow(options);
    if (!window) return tl::unexpected(window.error());
    window_ = std::move(*window);
    windowInput_ = std::make_unique<WindowInput>(window_->native(), played_);
    return {};
}

Result<void> ViewerApp::openRenderer() {
    shaderDirectory_ = options_.shaderDirectory.empty() ? findProgramFile("shaders").string()
                                                        : options_.shaderDirectory;
    jobs_ = createTbbJobs(0);
    RendererDesc desc;
    desc.loadGl = window_->loader();
    desc.jobs = jobs_.get();
    desc.log = {writeLog, const_cast<ViewerOptions*>(&options_)};
    desc.cacheDirectory = userCacheDirectory();
    desc.shaderDirectory = shaderDirectory_;
    auto renderer = Renderer::create(desc);
    if (!renderer) return tl::unexpected(renderer.error());
    renderer_ = std::move(*renderer);
    if (!shaderDirectory_.empty()) shaderWatch_.emplace(shaderDirectory_);
    auto ui = OverlayUi::create(*renderer_);
    if (!ui) return tl::unexpected(ui.error());
    ui_ = std::move(*ui);
    return {};
}

Result<void> ViewerApp::openEnvironment() {
    lighting_ = options_.lighting;
    if (options_.environment.empty()) return {};
    auto picture = loadPicture(options_.environment);
    if (!picture) return tl::unexpected(picture.error());
    std::vector<vec3> pixels(picture->pixelCount());
    for (size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = vec3(picture->rgba[4 * i], picture->rgba[4 * i + 1], picture->rgba[4 * i + 2]);
    EnvironmentDesc desc;
    desc.label = options_.environment;
    desc.width = picture->width;
    desc.height = picture->height;
    desc.pixels = pixels;
    auto environment = renderer_->createEnvironment(desc);
    if (!environment) return tl::unexpected(environment.error());
    environment_ = *environment;
    settings_.hasEnvironment = true;
    return {};
}

Result<void> ViewerApp::openLevel() {
    auto level = Level::load(options_.scene, *renderer_, jobs_.get());
    if (!level) return tl::unexpected(level.error());
    level_ = std::move(*level);
    // The whole folder: buffers and images lie beside the file.
    const std::filesystem::path folder = std::filesystem::path(options_.scene).parent_path();
    levelWatch_.emplace(folder.empty() ? "." : folder);
    if (game_) game_->levelLoaded(*level_);
    return {};
}

/// In this order: --eye and --target, --camera, the node "spawn", the file's first camera, one that
/// sees everything.
Result<void> ViewerApp::placeCamera() {
    const auto found = level_->camera(options_.camera);
    if (!options_.camera.empty() && !found)
        return fail(options_.scene, "There is no camera '" + options_.camera + "'; the file has " +
                                        std::to_string(level_->model().cameras.size()) + ".");
    lens_ = found ? *found : level_->framingCamera();
    CameraPose eyes{lens_.position, LookAngles::along(lens_.forward)};
    if (options_.eye) {
        eyes.position = *options_.eye;
        const vec3 toTarget = options_.target.value_or(level_->bounds().center()) - eyes.position;
        if (toTarget != vec3(0)) eyes.look = LookAngles::along(toTarget);
    }
    if (options_.verticalFov > 0) lens_.verticalFov = options_.verticalFov;
    vec3 feet = eyes.position - vec3(0, WalkCamera::kEyeHeight, 0);
    if (options_.cameraMode == CameraMode::walk)
        if (const auto hit = level_->collision().castDown(eyes.position, kGroundReach))
            feet.y = eyes.position.y - hit->distance;
    if (const auto spawn = level_->nodeNamed("spawn")) {
        feet = vec3((*spawn)[3]);
        if (options_.camera.empty() && !options_.eye)
            // A thing faces +z, unlike a camera (glTF 2.0, section 3.4).
            eyes = {feet + vec3(0, WalkCamera::kEyeHeight, 0),
                    LookAngles::along(vec3((*spawn)[2]))};
    }
    camera_.startAt(eyes, feet, options_.cameraMode);
    return {};
}

}  // namespace rushlight

#include "sandbox/viewer/viewer_app.h"

#include "renderer/capture/image_files.h"
#include "sandbox/viewer/program_files.h"

#include <chrono>
#include <cstdio>

namespace rushlight {
namespace {

constexpr double kScriptFrame = 1.0 / 60;  // seconds: where time is an input, not the clock's
constexpr double kMinimisedWait = 0.1;     // seconds
constexpr const char* kPictureFolder = "out";

double secondsNow() {
    using Clock = std::chrono::steady_clock;
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

}  // namespace

ViewerApp::ViewerApp(const ViewerOptions& options, ViewerGame* game)
    : options_(options), game_(game) {}

ViewerApp::~ViewerApp() {
    if (renderer_) renderer_->finish();
}

void ViewerApp::say(std::string_view line) const {
    std::fprintf(stderr, "%s: %.*s\n", options_.program.c_str(), int(line.size()), line.data());
}

Result<void> ViewerApp::run() {
    while (!done_) {
        const auto drawn = drawNextFrame();
        if (!drawn) return tl::unexpected(drawn.error());
        if (!*drawn) continue;
        if (isLastFrame()) break;
        ++frame_;
    }
    return {};
}

Result<bool> ViewerApp::drawNextFrame() {
    gatherInput();
    window_->framebufferSize(size_.x, size_.y);
    const double now = secondsNow();
    if (size_.x == 0 || size_.y == 0) {
        clock_.tick(now);
        windowInput_->waitFor(kMinimisedWait);
        done_ = done_ || window_->shouldClose();
        return false;
    }
    const bool timeIsInput = lastFrame_ || isScripted();
    clock_.tick(timeIsInput ? double(frame_) * kScriptFrame : now);
    handleKeys();
    watchFiles();
    if (auto advanced = advance(); !advanced) return tl::unexpected(advanced.error());
    const FrameInput frame = describeFrame();
    if (auto rendered = render(frame); !rendered) return tl::unexpected(rendered.error());
    if (frame_ == 0) say("first frame drawn");
    meter_.add(secondsNow() - now);
    return true;
}

void ViewerApp::gatherInput() {
    played_.beginFrame();
    windowInput_->poll();
    if (script_) {
        scripted_.beginFrame();
        script_->play(frame_, scripted_);
    }
    done_ = done_ || window_->shouldClose();
}

void ViewerApp::handleKeys() {
    handleEscape();
    handleMouse();
    handleViewKeys();
    if (input_->wasPressed(Key::f) || input_->wasPressed(Key::c))
        camera_.setMode(camera_.mode() == CameraMode::fly ? CameraMode::walk : CameraMode::fly);
    if (input_->wasPressed(Key::p)) wantsPicture_ = true;
    if (input_->wasPressed(Key::r)) {
        reloadShaders();
        reloadLevel();
    }
    if (input_->wasPressed(Key::tab)) {
        panelsOpen_ = !panelsOpen_;
        if (!isScripted()) windowInput_->captureMouse(!panelsOpen_);
    }
}

/// The first press gives the mouse back, the second ends the program. Heard from the window even
/// when a script plays.
void ViewerApp::handleEscape() {
    const bool pressed = played_.wasPressed(Key::escape) || input_->wasPressed(Key::escape);
    if (!pressed) return;
    if (windowInput_->isMouseCaptured())
        windowInput_->captureMouse(false);
    else
        done_ = true;
}

void ViewerApp::handleMouse() {
    const bool clicked = played_.wasPressed(MouseButton::left) && !panelsOpen_;
    if (clicked && !isScripted()) windowInput_->captureMouse(true);
}

void ViewerApp::handleViewKeys() {
    constexpr int kViews = int(DebugView::count);
    int view = int(settings_.frame.debugView);
    if (input_->wasPressed(Key::digit0) || input_->wasPressed(Key::backspace)) view = 0;
    const int shifted = input_->isDown(Key::shift) ? 9 : 0;
    for (int n = 1; n <= 9; ++n)
        if (input_->wasPressed(keyOffset(Key::digit0, n))) view = n + shifted;
    for (int n = 1; n <= 12; ++n)
        if (input_->wasPressed(keyOffset(Key::f1, n - 1))) view = n;
    if (input_->wasPressed(Key::pageDown)) view = (view + 1) % kViews;
    if (input_->wasPressed(Key::pageUp)) view = (view + kViews - 1) % kViews;
    if (view < kViews) settings_.frame.debugView = DebugView(view);
}

const TriangleGrid& ViewerApp::ground() {
    static const TriangleGrid kNothing;
    return camera_.mode() == CameraMode::walk ? level_->collision() : kNothing;
}

Result<void> ViewerApp::advance() {
    const auto seconds = float(clock_.delta());
    const bool held = input_->isDown(MouseButton::right) && !ui_->wantsMouse();
    const bool look = isScripted() || windowInput_->isMouseCaptured() || held;
    camera_.update(*input_, look, ground(), seconds);
    if (auto advanced = level_->advanceTo(clock_.elapsed()); !advanced) return advanced;
    lighting_ = options_.lighting;
    if (game_) {
        const CameraPose pose = camera_.pose();
        game_->update({clock_.elapsed(), seconds, pose, *input_, *level_, lighting_});
    }
    lighting_.ambientSky *= settings_.ambientScale;
    lighting_.ambientGround *= settings_.ambientScale;
    lighting_.environmentIntensity *= settings_.ambientScale;
    lighting_.fog.density *= settings_.fogScale;
    if (levelEnvironment_)
        lighting_.environmentIntensity *= level_->model().imageBasedLight->intensity;
    return {};
}

void ViewerApp::watchFiles() {
    const double now = secondsNow();
    if (shaderWatch_ && shaderWatch_->poll(now)) reloadShaders();
    if (levelWatch_ && levelWatch_->poll(now)) reloadLevel();
}

void ViewerApp::reloadShaders() {
    if (shaderDirectory_.empty()) return;
    const auto replaced = renderer_->reloadShaders();
    if (!replaced) {
        shaderProblem_ = replaced.error().text();
        say("error: " + shaderProblem_);
        return;
    }
    const bool mended = !shaderProblem_.empty();
    shaderProblem_.clear();
    if (mended || *replaced > 0)
        say("shaders loaded again: " + std::to_string(*replaced) + " programs replaced.");
}

void ViewerApp::reloadLevel() {
    auto level = Level::load(options_.scene, *renderer_, jobs_.get());
    if (!level) {
        levelProblem_ = level.error().text();
        say("error: " + levelProblem_);
        return;
    }
    level_ = std::move(*level);
    levelProblem_.clear();
    levelWatch_->accept();
    if (game_) game_->levelLoaded(*level_);
    if (auto lit = useLevelLight(); !lit) say("error: " + lit.error().text());
    say("level loaded again: " + options_.scene);
}

FrameInput ViewerApp::describeFrame() {
    FrameInput frame = describeScene();
    frame.settings.deltaTime = float(clock_.delta());
    frame.overlay = drawOverlay();
    return frame;
}

FrameInput ViewerApp::describeScene() const {
    FrameInput frame;
    frame.view.viewFromWorld = camera_.pose().viewFromWorld();
    frame.view.perspective = lens_.perspective;
    frame.view.verticalFov = lens_.verticalFov;
    frame.view.orthoHalfHeight = lens_.orthoHalfHeight;
    frame.view.nearPlane = lens_.nearPlane;
    frame.view.farPlane = lens_.farPlane;
    frame.instances = level_->instances();
    frame.previousTransforms = level_->previousTransforms();
    frame.lighting = lighting_;
    frame.lighting.directional = level_->directionalLights();
    frame.lighting.punctual = level_->punctualLights();
    if (settings_.useReflectionProbes) frame.lighting.reflectionProbes = level_->reflectionProbes();
    if (settings_.useEnvironment) frame.lighting.environment = environment_;
    const bool black = lighting_.background == Background::color &&
                       lighting_.backgroundColor == vec3(0);
    if (levelEnvironment_ && black) frame.lighting.background = Background::environment;
    frame.settings = settings_.frame;
    return frame;
}

Overlay ViewerApp::drawOverlay() {
    const bool mouse = panelsOpen_ && !isScripted() && !windowInput_->isMouseCaptured();
    ui_->begin(*input_, windowInput_->pixelsPerUnit(), mouse, size_, float(clock_.delta()));
    if (game_) game_->drawHud(*ui_);
    if (settings_.frame.debugView != DebugView::none)
        ui_->text(OverlayUi::Anchor::topCenter, vec2(0, 8), toText(settings_.frame.debugView),
                  vec4(1, 1, 0.6f, 1), true);
    if (panelsOpen_) {
        drawStatistics({renderer_->report(), meter_, renderer_->deviceName(), size_, allocations_,
                        options_.allocationCount != nullptr});
        drawPassViews(settings_.frame);
        drawSettings(settings_, camera_);
        drawHelp();
    }
    drawProblem("The shaders have an error", shaderProblem_, size_);
    drawProblem("The level cannot be loaded", levelProblem_, size_);
    return ui_->end();
}

Result<void> ViewerApp::render(const FrameInput& frame) {
    if (options_.allocationCount) allocationsBefore_ = options_.allocationCount();
    FrameTarget target;
    target.width = size_.x;
    target.height = size_.y;
    if (auto done = renderer_->render(frame, target); !done) return done;
    if (options_.allocationCount) allocations_ = options_.allocationCount() - allocationsBefore_;
    window_->swapBuffers();
    if (isLastFrame() && !options_.screenshot.empty())
        return savePicture(frame, options_.screenshot);
    if (wantsPicture_) {
        wantsPicture_ = false;
        const std::string path = freeFileName(kPictureFolder, "screenshot", "png");
        if (auto saved = savePicture(frame, path); !saved) say("error: " + saved.error().text());
    }
    return {};
}

Result<void> ViewerApp::savePicture(const FrameInput& frame, const std::string& path) {
    const auto ticket = renderer_->renderOffscreen(frame, size_.x, size_.y, CaptureKind::display);
    if (!ticket) return tl::unexpected(ticket.error());
    CapturedImage image;
    renderer_->takeCapture(*ticket, true, image);
    if (auto saved = saveImage(path, PictureView(image)); !saved) return saved;
    say("picture saved: " + path);
    return {};
}

}  // namespace rushlight

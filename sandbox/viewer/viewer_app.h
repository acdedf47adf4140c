#pragma once
// The running viewer behind runViewer.

#include "engine/input/input.h"
#include "engine/time/frame_clock.h"
#include "renderer/context/window.h"
#include "renderer/renderer.h"
#include "sandbox/viewer/camera_rig.h"
#include "sandbox/viewer/file_watch.h"
#include "sandbox/viewer/input_script.h"
#include "sandbox/viewer/level.h"
#include "sandbox/viewer/overlay_ui.h"
#include "sandbox/viewer/panels.h"
#include "sandbox/viewer/viewer.h"
#include "sandbox/viewer/window_input.h"

#include <memory>
#include <optional>
#include <string>

namespace rushlight {

class ViewerApp {
public:
    ViewerApp(const ViewerOptions& options, ViewerGame* game);
    ~ViewerApp();

    Result<void> open();
    Result<void> run();

private:
    // viewer_open.cpp
    Result<void> openWindow();
    Result<void> openRenderer();
    Result<void> openScript();
    Result<void> openLevel();
    Result<void> openEnvironment();
    Result<void> placeCamera();

    // viewer_light.cpp
    Result<void> useLevelLight();

    // viewer_app.cpp
    Result<bool> drawNextFrame();  ///< false while the window has no size
    void gatherInput();
    void handleKeys();
    void handleMouse();
    void handleEscape();
    void handleViewKeys();
    Result<void> advance();
    const TriangleGrid& ground();  ///< nothing for who flies
    void watchFiles();
    void reloadShaders();
    void reloadLevel();
    FrameInput describeFrame();
    FrameInput describeScene() const;  ///< without what is drawn over it
    Overlay drawOverlay();
    Result<void> render(const FrameInput& frame);
    Result<void> savePicture(const FrameInput& frame, const std::string& path);
    bool isLastFrame() const { return lastFrame_ && frame_ + 1 >= *lastFrame_; }
    bool isScripted() const { return script_.has_value(); }
    void say(std::string_view line) const;

    const ViewerOptions& options_;
    ViewerGame* game_;
    std::unique_ptr<JobSystem> jobs_;
    std::unique_ptr<Window> window_;
    std::unique_ptr<WindowInput> windowInput_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<OverlayUi> ui_;
    std::unique_ptr<Level> level_;
    EnvironmentHandle environment_;
    bool levelEnvironment_ = false;  ///< it is the image-based light of the file

    InputState played_;  ///< what the window says
    InputState scripted_;
    const InputState* input_ = &played_;
    std::optional<InputScript> script_;
    FrameClock clock_;
    FrameRateMeter meter_;
    CameraRig camera_;
    LevelCamera lens_;  ///< field of view and planes
    ViewerSettings settings_;
    Lighting lighting_;

    std::optional<FileWatch> shaderWatch_;
    std::optional<FileWatch> levelWatch_;
    std::string shaderDirectory_;
    std::string shaderProblem_;
    std::string levelProblem_;

    std::optional<uint32_t> lastFrame_;
    uint32_t frame_ = 0;
    uvec2 size_{0};
    bool panelsOpen_ = false;
    bool wantsPicture_ = false;
    bool done_ = false;
    uint64_t allocationsBefore_ = 0;
    uint64_t allocations_ = 0;
};

}  // namespace rushlight

#pragma once
// A window to look into a scene: `rushlight view` and the sandbox are this with and without a game
// in it.

#include "engine/core/log.h"
#include "renderer/frame/frame_input.h"
#include "sandbox/viewer/camera_rig.h"

#include <cstdint>
#include <optional>
#include <string>

namespace rushlight {

class Level;
class OverlayUi;

/// What a game sees of a frame, before it is drawn.
struct GameFrame {
    double time = 0;  ///< seconds since the start
    float delta = 0;  ///< seconds since the last frame
    const CameraPose& camera;
    const InputState& input;
    Level& level;  ///< its lights may be changed; they are as in the file at the start of each
                   ///< frame
    Lighting& lighting;
};

/// The rules on top of the viewer. Everything runs on the viewer's thread.
class ViewerGame {
public:
    virtual ~ViewerGame() = default;
    /// Also after the level was loaded again because its file changed.
    virtual void levelLoaded(Level&) {}
    virtual void update(const GameFrame&) {}
    virtual void drawHud(OverlayUi&) {}
};

struct ViewerOptions {
    std::string program = "rushlight";  ///< begins error messages
    std::string title = "Rushlight";
    std::string scene;  ///< glTF or GLB file
    uint32_t width = 1280;
    uint32_t height = 720;
    bool verticalSync = true;
    CameraMode cameraMode = CameraMode::fly;
    std::string camera;       ///< a camera's name or index; empty: the node "spawn", else the first
                              ///< camera
    std::optional<vec3> eye;  ///< with `target`, instead of a camera of the file
    std::optional<vec3> target;
    float verticalFov = 0;         ///< radians; 0: the camera's own
    std::string environment;       ///< a panorama (.hdr, .exr); empty: the hemisphere light of
                                   ///< `lighting`
    bool reflectionProbes = true;  ///< capture those of the file
    Lighting lighting;  ///< ambient and background; the spans and the environment are set by the
                        ///< viewer
    FrameSettings settings;
    std::string shaderDirectory;  ///< empty: found beside the program, else those compiled in
    uint32_t frames = 0;  ///< ends after so many, which then last 1/60 s each; 0: runs until closed
    std::string screenshot;  ///< a file for the last frame's picture; with `frames` 0 one frame is
                             ///< drawn
    std::string script;      ///< a file of input instead of the player's, see InputScript
    bool walkDemo = false;   ///< the built-in script
    bool showOverlay = false;                 ///< the panels are open from the start
    bool pinRasterThreads = false;            ///< steadier times on llvmpipe
    uint64_t (*allocationCount)() = nullptr;  ///< of the process so far, when the program counts
                                              ///< them
};

/// Opens the window and runs until it is closed. Returns the program's exit code: 0, 2 wrong usage,
/// 3 bad input, 4 no display or no OpenGL 4.5. Errors are one line on standard error.
int runViewer(const ViewerOptions& options, ViewerGame* game = nullptr);

}  // namespace rushlight

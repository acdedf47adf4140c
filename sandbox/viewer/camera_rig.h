#pragma once

#include "engine/input/input.h"
#include "engine/scene/cameras.h"

#include <cstdint>

namespace rushlight {

enum class CameraMode : uint8_t { fly, walk };
const char* toText(CameraMode mode);

/// The player's camera: flies or walks, and turns keys and mouse into what either wants.
class CameraRig {
public:
    static constexpr float kRadiansPerPixel = 0.0022f;

    /// Both cameras start here; `feet` is where the walker stands.
    void spawnAt(const vec3& feet, const LookAngles& look, CameraMode mode);
    /// As spawnAt, with the fly camera's eyes somewhere else.
    void startAt(const CameraPose& eyes, const vec3& feet, CameraMode mode);
    /// Goes on from here in the current mode.
    void placeAt(const CameraPose& eyes);
    void setMode(CameraMode mode);

    /// `look`: the mouse turns the camera.
    void update(const InputState& input, bool look, const TriangleGrid& level, float seconds);

    CameraMode mode() const { return mode_; }
    CameraPose pose() const;
    FlyCamera& fly() { return fly_; }
    const WalkCamera& walk() const { return walk_; }

private:
    static CameraIntent intentOf(const InputState& input, bool look);

    CameraMode mode_ = CameraMode::fly;
    FlyCamera fly_;
    WalkCamera walk_;
};

}  // namespace rushlight

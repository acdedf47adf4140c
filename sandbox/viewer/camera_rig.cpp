#include "sandbox/viewer/camera_rig.h"

namespace rushlight {

const char* toText(CameraMode mode) { return mode == CameraMode::fly ? "fly" : "walk"; }

void CameraRig::spawnAt(const vec3& feet, const LookAngles& look, CameraMode mode) {
    startAt({feet + vec3(0, WalkCamera::kEyeHeight, 0), look}, feet, mode);
}

void CameraRig::startAt(const CameraPose& eyes, const vec3& feet, CameraMode mode) {
    walk_.spawnAt(feet, eyes.look);
    fly_.placeAt(eyes);
    mode_ = mode;
}

void CameraRig::placeAt(const CameraPose& eyes) {
    if (mode_ == CameraMode::fly)
        fly_.placeAt(eyes);
    else
        walk_.placeEyesAt(eyes);
}

void CameraRig::setMode(CameraMode mode) {
    if (mode == mode_) return;
    const CameraPose eyes = pose();
    mode_ = mode;
    placeAt(eyes);
}

CameraIntent CameraRig::intentOf(const InputState& input, bool look) {
    CameraIntent intent;
    intent.forward = input.axis(Key::s, Key::w);
    intent.right = input.axis(Key::a, Key::d);
    intent.up = input.axis(Key::q, Key::e);
    intent.fast = input.isDown(Key::shift);
    if (look) {
        intent.turnYaw = -input.mouseDelta().x * kRadiansPerPixel;
        intent.turnPitch = -input.mouseDelta().y * kRadiansPerPixel;
        intent.scroll = input.scroll();
    }
    return intent;
}

void CameraRig::update(const InputState& input, bool look, const TriangleGrid& level,
                       float seconds) {
    const CameraIntent intent = intentOf(input, look);
    if (mode_ == CameraMode::fly)
        fly_.update(intent, seconds);
    else
        walk_.update(intent, level, seconds);
}

CameraPose CameraRig::pose() const { return mode_ == CameraMode::fly ? fly_.pose : walk_.pose(); }

}  // namespace rushlight

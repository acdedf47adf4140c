#include "engine/scene/cameras.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

/// At most of length 1: walking diagonally is not faster.
vec3 limited(const vec3& wish) {
    const float length = glm::length(wish);
    return length > 1 ? wish / length : wish;
}

}  // namespace

LookAngles LookAngles::along(const vec3& direction) {
    const vec3 d = glm::normalize(direction);
    LookAngles look;
    if (d.x != 0 || d.z != 0) look.yaw = std::atan2(-d.x, -d.z);
    look.pitch = std::clamp(std::asin(std::clamp(d.y, -1.0f, 1.0f)), -kMaxPitch, kMaxPitch);
    return look;
}

void LookAngles::turn(float deltaYaw, float deltaPitch) {
    yaw = std::remainder(yaw + deltaYaw, 2 * kPi);
    pitch = std::clamp(pitch + deltaPitch, -kMaxPitch, kMaxPitch);
}

vec3 LookAngles::forward() const {
    return {-std::sin(yaw) * std::cos(pitch), std::sin(pitch), -std::cos(yaw) * std::cos(pitch)};
}

vec3 LookAngles::right() const { return {std::cos(yaw), 0, -std::sin(yaw)}; }

vec3 LookAngles::up() const { return glm::cross(right(), forward()); }

mat4 CameraPose::viewFromWorld() const {
    const vec3 x = look.right();
    const vec3 y = look.up();
    const vec3 z = -look.forward();
    return {vec4(x.x, y.x, z.x, 0), vec4(x.y, y.y, z.y, 0), vec4(x.z, y.z, z.z, 0),
            vec4(-glm::dot(x, position), -glm::dot(y, position), -glm::dot(z, position), 1)};
}

void FlyCamera::placeAt(const CameraPose& newPose) {
    pose = newPose;
    velocity_ = vec3(0);
}

void FlyCamera::update(const CameraIntent& intent, float seconds) {
    pose.look.turn(intent.turnYaw, intent.turnPitch);
    speed = std::clamp(speed * std::pow(1.2f, intent.scroll), kMinSpeed, kMaxSpeed);
    const vec3 wish = limited(pose.look.forward() * intent.forward +
                              pose.look.right() * intent.right + vec3(0, intent.up, 0));
    const vec3 target = wish * (intent.fast ? speed * kFastFactor : speed);
    // v' = k (target - v) has v(t) = target + (v0 - target) e^-kt; the way is its integral.
    const float decay = std::exp(-kResponse * seconds);
    const vec3 apart = velocity_ - target;
    pose.position += target * seconds + apart * ((1 - decay) / kResponse);
    velocity_ = target + apart * decay;
}

void WalkCamera::stand(const vec3& feet) {
    body_.placeAt(feet);
    velocity_ = vec3(0);
    eyeHeight_ = feet.y + kEyeHeight;
    eyes_ = previousEyes_ = feet + vec3(0, kEyeHeight, 0);
}

void WalkCamera::spawnAt(const vec3& feet, const LookAngles& look) {
    spawn_ = feet;
    spawnLook_ = look_ = look;
    stand(feet);
}

void WalkCamera::placeEyesAt(const CameraPose& newPose) {
    look_ = newPose.look;
    stand(newPose.position - vec3(0, kEyeHeight, 0));
}

void WalkCamera::update(const CameraIntent& intent, const TriangleGrid& level, float seconds) {
    look_.turn(intent.turnYaw, intent.turnPitch);
    for (uint32_t steps = clock_.advance(seconds); steps > 0; --steps) stepOnce(intent, level);
}

void WalkCamera::stepOnce(const CameraIntent& intent, const TriangleGrid& level) {
    const auto seconds = float(kStep);
    const vec3 ahead(-std::sin(look_.yaw), 0, -std::cos(look_.yaw));
    const vec3 wish = limited(ahead * intent.forward + look_.right() * intent.right);
    const vec3 target = wish * (intent.fast ? kRunSpeed : kWalkSpeed);
    velocity_ = target + (velocity_ - target) * std::exp(-kResponse * seconds);
    body_.step(level, velocity_, seconds);
    if (!level.isEmpty() && body_.feet().y < level.bounds().low.y - kFallLimit) {
        look_ = spawnLook_;
        stand(spawn_);
        return;
    }
    // A fall is followed at once; on the ground the eyes glide over steps.
    const float height = body_.feet().y + kEyeHeight;
    eyeHeight_ = body_.isOnGround()
                     ? height + (eyeHeight_ - height) * std::exp(-kEyeResponse * seconds)
                     : height;
    previousEyes_ = eyes_;
    eyes_ = vec3(body_.feet().x, eyeHeight_, body_.feet().z);
}

CameraPose WalkCamera::pose() const {
    return {glm::mix(previousEyes_, eyes_, float(clock_.fraction())), look_};
}

}  // namespace rushlight

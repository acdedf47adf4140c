#pragma once
// Cameras that a player moves: one that flies and one that walks. Both look with yaw and pitch, so
// there is never a roll, and both move the same way at 30 as at 240 frames a second.

#include "engine/core/math.h"
#include "engine/physics/character.h"
#include "engine/physics/triangle_grid.h"
#include "engine/time/frame_clock.h"

namespace rushlight {

/// Radians. Yaw 0 looks along -z and grows to the left; pitch grows upwards.
struct LookAngles {
    /// Short of straight up and down, where yaw would have no meaning and a look-at matrix no
    /// answer.
    static constexpr float kMaxPitch = kPi / 2 - 0.001f;

    float yaw = 0;
    float pitch = 0;

    static LookAngles along(const vec3& direction);
    void turn(float deltaYaw, float deltaPitch);

    vec3 forward() const;
    vec3 right() const;  ///< always level
    vec3 up() const;
};

/// What the player wants, in the camera's own terms; each axis in [-1, 1].
struct CameraIntent {
    float forward = 0;
    float right = 0;
    float up = 0;
    float turnYaw = 0;    ///< radians in this frame
    float turnPitch = 0;  ///< radians in this frame
    bool fast = false;
    float scroll = 0;  ///< steps: changes the fly camera's speed
};

struct CameraPose {
    vec3 position{0};
    LookAngles look;

    mat4 viewFromWorld() const;
};

/// Moves freely; the speed follows the wish exponentially, integrated exactly over each frame.
class FlyCamera {
public:
    static constexpr float kMinSpeed = 0.05f;  // metres a second
    static constexpr float kMaxSpeed = 500;
    static constexpr float kFastFactor = 4;
    static constexpr float kResponse = 12;  // 1/s: after 1/12 s a start or stop is 63 % done

    void update(const CameraIntent& intent, float seconds);
    void placeAt(const CameraPose& pose);

    CameraPose pose;
    float speed = 4;  ///< metres a second
    const vec3& velocity() const { return velocity_; }

private:
    vec3 velocity_{0};
};

/// Walks on the level at eye height, in steps of 1/60 s; what is shown lies between the last two
/// steps.
class WalkCamera {
public:
    static constexpr float kEyeHeight = 1.7f;
    static constexpr float kWalkSpeed = 2.4f;  // metres a second
    static constexpr float kRunSpeed = 5.5f;
    static constexpr float kResponse = 14;     // 1/s, of the velocity
    static constexpr float kEyeResponse = 16;  // 1/s, of the eyes after a step up or down
    static constexpr double kStep = 1.0 / 60;
    static constexpr float kFallLimit = 20;  // metres below the level's lowest point: back to the
                                             // spawn

    /// Stands at `feet`; also where a fall out of the world ends.
    void spawnAt(const vec3& feet, const LookAngles& look);
    /// Goes on from here, keeping the spawn.
    void placeEyesAt(const CameraPose& pose);
    void update(const CameraIntent& intent, const TriangleGrid& level, float seconds);

    CameraPose pose() const;
    const Character& body() const { return body_; }

private:
    void stepOnce(const CameraIntent& intent, const TriangleGrid& level);
    void stand(const vec3& feet);

    Character body_;
    LookAngles look_;
    FixedStep clock_{kStep};
    vec3 spawn_{0};
    LookAngles spawnLook_;
    vec3 velocity_{0};
    float eyeHeight_ = 0;  ///< above zero, smoothed
    vec3 eyes_{0};
    vec3 previousEyes_{0};
};

}  // namespace rushlight

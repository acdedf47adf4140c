#pragma once
// What a file may leave open, filled in the same way wherever a file is rendered as it is.

#include "engine/core/bounds.h"
#include "renderer/frame/frame_input.h"

namespace rushlight {

/// All of `bounds` in a picture of `aspect`, width over height, seen from the front and a little
/// from above.
View viewThatFrames(const Aabb& bounds, float verticalFov, float aspect);

/// For a scene without lights and environment: a sun from behind the camera and light from around.
struct DefaultLights {
    DirectionalLight sun;
    vec3 ambientSky{0.6f}, ambientGround{0.35f};
};
DefaultLights defaultLights(const View& view);

}  // namespace rushlight

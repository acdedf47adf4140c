#pragma once

#include "renderer/answers/diagnose.h"
#include "renderer/answers/editable_frame.h"

namespace rushlight {

/// The frame with that one thing changed; nothing where there is nothing to change. `evidence` has
/// the instances and their materials.
std::optional<EditableFrame> makeTrial(Trial trial, const FrameInput& input,
                                       const FrameEvidence& evidence, TrialMaterials& materials);

/// Whether a point is inside of the box, by more than a hair.
bool holds(const Aabb& box, const vec3& point);
/// Which of the instances have the eye within their boxes although most others lie outside of it:
/// an object and no room.
bool surroundsEye(const FrameEvidence& evidence, size_t instance, const vec3& eye);
vec3 eyeOf(const View& view);

}  // namespace rushlight

#pragma once
// Where the instances of a frame are, as a view sees them.

#include "renderer/answers/diagnose.h"

namespace rushlight {

struct FrameSurvey {
    uint32_t instances = 0;  ///< that are not rejected
    uint32_t inView = 0;     ///< their boxes touch the frustum
    uint32_t behind = 0;     ///< wholly behind the eye
    uint32_t aside = 0;      ///< before the eye, outside of the view's sides
    uint32_t beyondFar = 0;
    uint32_t beforeNear = 0;
    float nearest = 0, farthest = 0;  ///< metres along the view of the boxes' nearest and farthest
                                      ///< points
};

FrameSurvey survey(const View& view, float aspect, std::span<const InstanceFacts> instances);
/// How many there are in view when the same camera is given by another matrix; none where that is
/// no good one.
uint32_t inViewOf(View view, const mat4& viewFromWorld, float aspect,
                  std::span<const InstanceFacts> instances);

}  // namespace rushlight

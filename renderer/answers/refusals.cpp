#include "renderer/answers/findings.h"

#include <cmath>
#include <cstdio>

namespace rushlight {
namespace {

bool judgeMatrix(Judgement& j) {
    const mat4& m = j.input.view.viewFromWorld;
    if (!isFinite(m)) {
        j.add(Cause::viewNotFinite, 1, "The view matrix holds NaN or infinite values.",
              "Look for a division by zero where viewFromWorld is made, such as an eye that is its "
              "own "
              "target or an up vector along the view.");
        return true;
    }
    if (std::abs(glm::determinant(m)) >= 1e-12f) return false;
    j.add(
        Cause::viewNotInvertible, 1,
        "The view matrix has the determinant " + number(glm::determinant(m)) + ".",
        "Give a matrix that can be inverted: no axis of the camera may be scaled to nothing, and a "
        "matrix that was never set is all zero.");
    return true;
}

bool judgeFieldOfView(Judgement& j) {
    const View& view = j.input.view;
    if (!view.perspective || (view.verticalFov > 0 && view.verticalFov < 3.1f)) return false;
    std::string suggestion = "Give the vertical field of view in radians, above 0 and below 3.1.";
    if (view.verticalFov >= 3.1f)
        suggestion = "It looks like degrees: in radians it is " +
                     number(glm::radians(view.verticalFov)) + ".";
    j.add(Cause::fieldOfView, 1,
          "The vertical field of view is " + number(view.verticalFov) + " rad.", suggestion);
    return true;
}

bool judgePlanes(Judgement& j) {
    const View& view = j.input.view;
    const bool good = std::isfinite(view.nearPlane) && std::isfinite(view.farPlane) &&
                      (view.nearPlane > 0 || !view.perspective) &&
                      (view.farPlane > view.nearPlane || (view.farPlane == 0 && view.perspective));
    if (good) return false;
    j.add(
        Cause::nearFarOrder, 1,
        "The near plane is at " + number(view.nearPlane) + " m and the far plane at " +
            number(view.farPlane) + " m.",
        "The near plane must be above 0 and the far plane beyond it (0: infinitely far). Depth is "
        "reversed inside of the renderer; do not exchange the two for it.");
    return true;
}

}  // namespace

std::string number(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.4g", value + 0.0);  // no -0
    return buffer;
}

std::string text(const vec3& v) {
    char buffer[96];
    std::snprintf(buffer, sizeof buffer, "(%s, %s, %s)", number(v.x).c_str(), number(v.y).c_str(),
                  number(v.z).c_str());
    return buffer;
}

std::string percent(double share) { return number(share * 100) + " %"; }

void judgeRefusal(Judgement& j) {
    const FrameEvidence& e = j.evidence;
    if (!e.refusal) return;
    if (e.size.x == 0 || e.size.y == 0 || e.size.x > 16384 || e.size.y > 16384)
        return j.add(Cause::targetSize, 1,
                     "The target has " + std::to_string(e.size.x) + "x" + std::to_string(e.size.y) +
                         " pixels.",
                     "Give a target of 1 to 16,384 pixels a side; a minimised window has none.");
    if (judgeMatrix(j) || judgeFieldOfView(j) || judgePlanes(j)) return;
    j.add(Cause::refused, 1, "The renderer refuses the frame: " + e.refusal->text(),
          "Mend what the message names; nothing is drawn before.");
}

}  // namespace rushlight

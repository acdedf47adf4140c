// Where the camera looks, and what is left to be seen.
#include "renderer/answers/findings.h"
#include "renderer/answers/trials.h"

#include <algorithm>

namespace rushlight {
namespace {

std::string of(uint32_t part, uint32_t all, const char* what) {
    return std::to_string(part) + " of " + std::to_string(all) + " objects are " + what;
}

/// 0.3 for a few to 1 for all.
float weight(uint32_t part, uint32_t all) {
    return all ? 0.3f + 0.7f * float(part) / float(all) : 0;
}

bool isAffine(const mat4& m) {
    return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1;
}

void judgeMatrixUse(Judgement& j) {
    const FrameSurvey& s = j.survey;
    const mat4& m = j.input.view.viewFromWorld;
    const auto& all = j.evidence.instances;
    if (!isAffine(m)) {
        const uint32_t seen = inViewOf(j.input.view, glm::transpose(m), j.aspect(), all);
        j.add(
            Cause::viewTransposed, isAffine(glm::transpose(m)) ? 1.0f : 0.4f,
            "The last row of the view matrix is (" + number(m[0][3]) + ", " + number(m[1][3]) +
                ", " + number(m[2][3]) + ", " + number(m[3][3]) +
                ") and not (0, 0, 0, 1); transposed it "
                "sees " +
                std::to_string(seen) + " of " + std::to_string(s.instances) + " objects.",
            "Pass viewFromWorld with its columns one after the other, as GLM and OpenGL have them; "
            "transpose a matrix that is stored by rows.");
    }
    const uint32_t seen = inViewOf(j.input.view, glm::inverse(m), j.aspect(), all);
    if (s.inView == 0 && 2 * seen >= s.instances && seen > 0)
        j.add(Cause::viewInverted, 0.97f,
              "The view sees no object; its inverse sees " + std::to_string(seen) + " of " +
                  std::to_string(s.instances) + ".",
              "viewFromWorld takes points of the world into the camera's space; pass the inverse "
              "of the "
              "camera's own transform.");
}

void judgeDirection(Judgement& j) {
    const FrameSurvey& s = j.survey;
    const vec3 eye = eyeOf(j.input.view);
    const vec3 forward = -glm::normalize(vec3(glm::inverse(j.input.view.viewFromWorld)[2]));
    const std::string camera = "; the camera is at " + text(eye) + " and looks along " +
                               text(forward) + ".";
    if (s.behind > 0)
        j.add(Cause::behindCamera, 0.93f * weight(s.behind, s.instances),
              of(s.behind, s.instances, "behind the camera") + camera,
              "The camera looks along -z of its own space, right-handed: turn it round, or turn a "
              "left-handed view by 180 degrees about its up axis.");
    if (s.aside > 0)
        j.add(
            Cause::outsideView, 0.9f * weight(s.aside, s.instances),
            of(s.aside, s.instances, "beside, above or below what the camera sees") + camera,
            "Point the camera at the scene; where it should see it, check that both have the same "
            "up axis (y) and the same unit (metres).");
    if (s.inView > 0 && s.behind + s.aside == 0 && j.evidence.hasPictures)
        j.add(Cause::outsideView, 0.3f,
              "The boxes of " + of(s.inView, s.instances, "in view") +
                  ", but no surface of theirs is" + camera,
              "Point the camera at the surfaces themselves.");
}

void judgePlanes(Judgement& j) {
    const FrameSurvey& s = j.survey;
    const View& view = j.input.view;
    const std::string range = "; the scene spans " + number(s.nearest) + " to " +
                              number(s.farthest) + " m before the camera, the view " +
                              number(view.nearPlane) + " to " +
                              (view.farPlane > 0 ? number(view.farPlane) + " m." : "infinity.");
    const bool wider = j.evidence.of(Trial::planesApart).look.drawn >= 0.0005f;
    const bool far = s.beyondFar > 0 || (wider && view.farPlane > 0 && s.farthest > view.farPlane);
    const bool near = s.beforeNear > 0 || (wider && s.nearest < view.nearPlane);
    if (far && s.beyondFar >= s.beforeNear)
        j.add(Cause::beyondFar, wider ? 0.98f : 0.96f * weight(s.beyondFar, s.instances),
              of(s.beyondFar, s.instances, "beyond the far plane") + range,
              "Move the far plane beyond the scene, or set it to 0 for infinity, which costs "
              "nothing.");
    if (near && s.beforeNear >= s.beyondFar)
        j.add(Cause::beforeNear, wider ? 0.98f : 0.96f * weight(s.beforeNear, s.instances),
              of(s.beforeNear, s.instances, "nearer than the near plane") + range,
              "Move the near plane closer to the camera; check that the scene is in metres.");
}

void judgeSize(Judgement& j) {
    const FrameReport& r = j.evidence.report;
    const uint32_t small = r.culledSmall;
    float largest = 0;
    for (const InstanceFacts& facts : j.evidence.instances)
        if (!facts.rejected)
            largest = std::max(largest, glm::length(facts.bounds.halfExtent()) * 2);
    const bool point = largest == 0;
    if (small == 0 && !point) return;
    const float limit = j.input.settings.smallObjectPixels;
    j.add(Cause::tooSmall, 0.97f * (point ? 1 : weight(small, j.survey.inView)),
          of(small, r.instances, "smaller than ") + number(limit) +
              " pixels across and are left out; the largest of all measures " + number(largest) +
              " m.",
          "Check the unit and the scale of the transforms (the renderer's unit is the metre), or "
          "bring "
          "the camera closer.");
}

}  // namespace

void judgeContents(Judgement& j) {
    const FrameEvidence& e = j.evidence;
    if (e.instances.empty())
        return j.add(
            Cause::emptyScene, 1,
            "The frame has no objects: FrameInput::instances and the world are empty.",
            "Fill FrameInput::instances, or set FrameInput::world to a world that has instances; "
            "of a file, check that its default scene has nodes with meshes.");
    uint32_t stale = 0, notFinite = 0;
    for (const InstanceFacts& facts : e.instances) {
        stale += facts.rejected && (facts.staleMesh || facts.staleMaterial);
        notFinite += facts.rejected && facts.notFinite;
    }
    const uint32_t all = uint32_t(e.instances.size());
    const bool empty = e.look.isEmpty() || !e.hasPictures;
    const float certainty = empty && stale + notFinite == all ? 1.0f : 0.5f;
    if (stale > 0 && (empty || 2 * stale >= all))
        j.add(Cause::staleHandles, certainty * weight(stale, all),
              of(stale, all, "left out because their mesh or material handle is stale or none."),
              "Keep meshes and materials alive as long as instances use them, and set "
              "Instance::mesh.");
    if (notFinite > 0 && (empty || 2 * notFinite >= all))
        j.add(Cause::transformsNotFinite, certainty * weight(notFinite, all),
              of(notFinite, all,
                 "left out because their transform is not finite or their previous "
                 "transform is missing."),
              "Look for NaN in Instance::worldFromLocal: a division by a zero scale, a quaternion "
              "that is "
              "not normalised, an index beyond previousTransforms.");
}

void judgeView(Judgement& j) {
    if (j.survey.instances == 0) return;
    judgeMatrixUse(j);
    judgeDirection(j);
    judgePlanes(j);
    judgeSize(j);
    const uint32_t hidden = j.evidence.report.culledOcclusion;
    if (hidden > 0 && j.evidence.revives(Trial::noOcclusionCulling))
        j.add(Cause::occlusion, 0.9f,
              of(hidden, j.survey.instances,
                 "taken to be hidden; without occlusion culling the frame is fine."),
              "Set FrameSettings::occlusionCulling to false and report the scene.");
}

}  // namespace rushlight

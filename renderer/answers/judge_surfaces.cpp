// What is in view and still not seen, or seen from where nothing can be told.
#include "renderer/answers/findings.h"
#include "renderer/answers/trials.h"

#include <algorithm>

namespace rushlight {
namespace {

bool draws(const Judgement& j, Trial trial) {
    return j.evidence.of(trial).tried && j.evidence.of(trial).look.drawn >= 0.0005f;
}

void judgeAlpha(Judgement& j) {
    float alpha = 0;
    uint32_t cut = 0, blended = 0;
    for (const MaterialDesc& material : j.evidence.materials) {
        alpha = std::max(alpha, material.baseColor.a);
        cut += material.alphaMode == AlphaMode::mask;
        blended += material.alphaMode == AlphaMode::blend;
    }
    j.add(Cause::alpha, 0.96f,
          std::to_string(blended) + " objects are blended and " + std::to_string(cut) +
              " cut by alpha; the largest alpha of their base colours is " + number(alpha) +
              "; in opaque white " + percent(j.evidence.of(Trial::whiteMaterials).look.drawn) +
              " of the picture is drawn.",
          "Give the base colour or its texture an alpha above 0 (above alphaCutoff where it is a "
          "mask), "
          "or set alphaMode to opaque.");
}

void judgeBacks(Judgement& j) {
    const vec3 eye = eyeOf(j.input.view);
    uint32_t around = 0;
    for (size_t i = 0; i < j.evidence.instances.size(); ++i)
        around += surroundsEye(j.evidence, i, eye);
    const std::string drawn = percent(j.evidence.of(Trial::doubleSided).look.drawn);
    if (around > 0)
        j.add(Cause::cameraInside, 0.95f,
              "The camera at " + text(eye) + " is inside of " + std::to_string(around) +
                  " objects, whose backs are not drawn; seen from both sides they cover " + drawn +
                  " of the picture.",
              "Move the camera out of the object, or check the object's scale; make what is to be "
              "seen "
              "from within double-sided.");
    const bool mirrored = glm::determinant(j.input.view.viewFromWorld) < 0;
    j.add(Cause::backFaces, around > 0 ? 0.5f : 0.95f,
          "Only back faces are in view: seen from both sides they cover " + drawn +
              " of the picture, as they are nothing." +
              (mirrored ? " The view matrix mirrors: its determinant is negative." : ""),
          mirrored ? "Give a view without a mirror; for a left-handed camera negate its z axis and "
                     "its x axis."
                   : "Front faces are counter-clockwise: reverse the indices of each triangle, or "
                     "make the "
                     "material double-sided.");
}

/// The eye is in something that the picture is filled by.
void judgeInside(Judgement& j) {
    if (!j.evidence.revives(Trial::eyeFreed)) return;
    const vec3 eye = eyeOf(j.input.view);
    for (size_t i = 0; i < j.evidence.instances.size(); ++i) {
        if (!surroundsEye(j.evidence, i, eye)) continue;
        const Aabb& box = j.evidence.instances[i].bounds;
        return j.add(Cause::cameraInside, 0.97f,
                     "The camera at " + text(eye) + " is inside of object " +
                         std::to_string(j.evidence.instances[i].instance.id) + ", which spans " +
                         text(box.low) + " to " + text(box.high) +
                         "; without it the frame is fine.",
                     "Move the camera out of the object, or check the object's scale.");
    }
}

}  // namespace

void judgeSurfaces(Judgement& j) {
    if (j.evidence.revives(Trial::usualFieldOfView))
        j.add(Cause::fieldOfView, 0.95f,
              "The vertical field of view is " + number(j.input.view.verticalFov) +
                  " rad; with 0.785 the frame is fine.",
              "Give the field of view in radians; one that was turned into radians twice is this "
              "small.");
    if (!j.evidence.look.isEmpty()) return judgeInside(j);
    if (draws(j, Trial::whiteMaterials))
        judgeAlpha(j);
    else if (draws(j, Trial::doubleSided))
        judgeBacks(j);
}

}  // namespace rushlight

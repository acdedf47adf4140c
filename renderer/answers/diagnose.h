#pragma once
// Why is this frame black, white or empty? Facts are measured in the frame: what the input says,
// the frame's counters, its pictures read back, and trials: the frame again with one suspect taken
// away (without fog, with the sun turned round, in white). The cause whose absence brings the
// picture to life is named first.

#include "renderer/answers/picture_statistics.h"
#include "renderer/renderer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace rushlight {

enum class Cause : uint8_t {
    targetSize,
    viewNotFinite,
    viewNotInvertible,
    viewTransposed,
    viewInverted,
    fieldOfView,
    nearFarOrder,
    refused,  ///< the renderer says why
    emptyScene,
    transformsNotFinite,
    staleHandles,
    behindCamera,
    outsideView,
    beyondFar,
    beforeNear,
    tooSmall,
    occlusion,
    backFaces,
    alpha,
    cameraInside,
    noLights,
    lightsTooWeak,
    lightsOutOfRange,
    lightDirection,
    shadowed,
    exposure,
    blackMaterials,
    mirrorsNothing,
    fog,
    notFinite,
    shownImage,
    count
};
/// Stable names, as "behind-camera".
const char* toText(Cause cause);

struct Finding {
    Cause cause = Cause::count;
    float score = 0;         ///< (0, 1]: how sure it is
    std::string evidence;    ///< a sentence with the values
    std::string suggestion;  ///< a sentence
};

/// What is tried on the frame, one thing at a time.
enum class Trial : uint8_t {
    frameShown,  ///< FrameSettings::debugView is the frame
    noFog,
    noShadows,
    lightsTurned,     ///< suns, spots and flat lights shine the other way
    lightsUnbounded,  ///< point and spot lights without range
    whiteMaterials,   ///< opaque, white, rough; backs are culled where they were
    doubleSided,      ///< the same, and seen from both sides
    noMetals,
    suitedExposure,  ///< by the radiance that there is
    planesApart,     ///< a very near near plane and no far plane
    usualFieldOfView,
    eyeFreed,  ///< without what the eye is inside of
    noOcclusionCulling,
    count
};
struct TrialResult {
    bool tried = false;
    FrameLook look;
};

/// All that is measured; see gatherEvidence.
struct FrameEvidence {
    uvec2 size{0};
    std::optional<Error> refusal;  ///< of Renderer::render; then nothing below is known
    FrameReport report;
    std::vector<InstanceFacts> instances;
    bool hasPictures = false;  ///< false with the null backend, which draws nothing
    FrameLook look;
    SurfaceLook surface;
    float exposureFactor = 1;
    std::array<TrialResult, size_t(Trial::count)> trials;
    std::vector<MaterialDesc> materials;  ///< of the instances, as `instances`

    const TrialResult& of(Trial trial) const { return trials[size_t(trial)]; }
    bool revives(Trial trial) const { return of(trial).tried && of(trial).look.isFine(); }
};

struct Diagnosis {
    FrameLook look;                 ///< what the frame looks like
    std::vector<Finding> findings;  ///< the surest first; empty when the frame is fine
    bool isFine() const { return findings.empty(); }
};

/// Renders the frame, and its trials when it is black, white or empty. Offscreen; some 5 frames
/// when it is fine, about 20 else. A small size is enough, but objects are left out by their size
/// in pixels.
FrameEvidence gatherEvidence(Renderer& renderer, const FrameInput& input, uvec2 size);

/// Ranks what the evidence says. Renders nothing.
Diagnosis diagnose(const FrameInput& input, const FrameEvidence& evidence);

inline Diagnosis diagnose(Renderer& renderer, const FrameInput& input, uvec2 size) {
    return diagnose(input, gatherEvidence(renderer, input, size));
}

}  // namespace rushlight

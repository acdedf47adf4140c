#include "renderer/answers/diagnose.h"

#include "renderer/answers/findings.h"

#include <algorithm>
#include <iterator>

namespace rushlight {

const char* toText(Cause cause) {
    // Indexed by Cause.
    constexpr const char* kNames[] = {"target-size",
                                      "view-not-finite",
                                      "view-not-invertible",
                                      "view-transposed",
                                      "view-inverted",
                                      "field-of-view",
                                      "near-far-order",
                                      "refused",
                                      "empty-scene",
                                      "transforms-not-finite",
                                      "stale-handles",
                                      "behind-camera",
                                      "outside-view",
                                      "beyond-far",
                                      "before-near",
                                      "too-small",
                                      "occlusion",
                                      "back-faces",
                                      "alpha",
                                      "camera-inside",
                                      "no-lights",
                                      "lights-too-weak",
                                      "lights-out-of-range",
                                      "light-direction",
                                      "shadowed",
                                      "exposure",
                                      "black-materials",
                                      "mirrors-nothing",
                                      "fog",
                                      "not-finite",
                                      "shown-image"};
    static_assert(std::size(kNames) == size_t(Cause::count));
    return cause < Cause::count ? kNames[size_t(cause)] : "?";
}

Diagnosis diagnose(const FrameInput& input, const FrameEvidence& evidence) {
    Judgement j{input, evidence, {}, {}};
    judgeRefusal(j);
    Diagnosis diagnosis{evidence.look, {}};
    const bool fine = evidence.hasPictures && evidence.look.isFine() && !evidence.instances.empty();
    if (fine && evidence.look.isMostlyBlack()) judgeMaterials(j);
    if (!evidence.refusal && !fine) {
        j.survey = survey(input.view, j.aspect(), evidence.instances);
        judgeContents(j);
        const bool unseen = evidence.hasPictures ? evidence.look.isEmpty() : j.survey.inView == 0;
        if (unseen) judgeView(j);
        judgeSurfaces(j);
        if (!evidence.instances.empty() && !unseen) {
            judgeLights(j);
            judgeLook(j);
            judgeExposure(j);
        }
    }
    std::ranges::stable_sort(j.findings, std::greater<>{}, &Finding::score);
    diagnosis.findings = std::move(j.findings);
    return diagnosis;
}

}  // namespace rushlight

#pragma once
// The judges: each looks at one kind of evidence and adds what it finds.

#include "renderer/answers/frame_survey.h"

namespace rushlight {

struct Judgement {
    const FrameInput& input;
    const FrameEvidence& evidence;
    FrameSurvey survey;
    std::vector<Finding> findings;

    void add(Cause cause, float score, std::string evidenceText, std::string suggestion) {
        findings.push_back({cause, score, std::move(evidenceText), std::move(suggestion)});
    }
    float aspect() const { return float(evidence.size.x) / float(evidence.size.y); }
};

/// What the renderer refused to draw.
void judgeRefusal(Judgement&);
/// A scene in which nothing can be seen, whatever the camera.
void judgeContents(Judgement&);
/// Nothing is drawn of what there is.
void judgeView(Judgement&);
void judgeSurfaces(Judgement&);
/// Something is drawn, and it is black, white or of one colour.
void judgeLights(Judgement&);
void judgeLook(Judgement&);
void judgeMaterials(Judgement&);
void judgeExposure(Judgement&);

/// With up to four digits.
std::string number(double value);
std::string text(const vec3& v);
std::string percent(double share);
bool hasAmbientLight(const Lighting& lighting);

}  // namespace rushlight

// What is drawn, and black, white or of one colour.
#include "renderer/answers/findings.h"
#include "renderer/lighting/clusters/light_clusters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rushlight {
namespace {

float peak(const vec3& v) { return std::max({v.x, v.y, v.z}); }

/// The brightest light of any kind, in its unit.
float brightestLight(const Lighting& lighting) {
    float most = 0;
    for (const DirectionalLight& light : lighting.directional)
        most = std::max(most, peak(light.illuminance));
    for (const PunctualLight& light : lighting.punctual)
        most = std::max(most, peak(light.intensity));
    for (const AreaLight& light : lighting.area) most = std::max(most, peak(light.luminance));
    return most;
}

size_t lightCount(const Lighting& l) {
    return l.directional.size() + l.punctual.size() + l.area.size();
}

bool anythingGlows(const FrameEvidence& e) {
    return std::ranges::any_of(
        e.materials, [](const MaterialDesc& m) { return m.unlit || peak(m.emissive) > 0; });
}

/// Of all lights that are not suns: metres from where the best of them stops to the nearest object.
float leastGap(const Judgement& j) {
    float least = std::numeric_limits<float>::max();
    const auto look = [&](const auto& light) {
        for (const InstanceFacts& facts : j.evidence.instances) {
            if (facts.rejected) continue;
            const vec3 outside = glm::max(
                glm::abs(light.position - facts.bounds.center()) - facts.bounds.halfExtent(),
                vec3(0));
            least = std::min(least, glm::length(outside) - effectiveRange(light));
        }
    };
    for (const PunctualLight& light : j.input.lighting.punctual) look(light);
    for (const AreaLight& light : j.input.lighting.area) look(light);
    return least;
}

void judgeReach(Judgement& j) {
    const Lighting& l = j.input.lighting;
    if (l.punctual.empty() && l.area.empty()) return;
    const float gap = leastGap(j);
    const bool alone = l.directional.empty() && !hasAmbientLight(l);
    const bool revived = j.evidence.revives(Trial::lightsUnbounded);
    if (!revived && !(alone && gap > 0)) return;
    float range = 0;
    for (const PunctualLight& light : l.punctual) range = std::max(range, effectiveRange(light));
    for (const AreaLight& light : l.area) range = std::max(range, effectiveRange(light));
    j.add(Cause::lightsOutOfRange, revived ? 0.95f : 0.8f,
          "The lights reach " + number(range) + " m at most; " +
              (gap > 0 ? "the nearest object is " + number(gap) + " m further away"
                       : std::string("what they reach is not what is seen")) +
              (revived ? "; without ranges the frame is fine." : "."),
          "Give the lights a larger range (0: unbounded), or move them closer; ranges are in "
          "metres.");
}

/// Light that travels upwards is rarely meant.
bool anySunRises(const Lighting& l) {
    return std::ranges::any_of(l.directional, [](const DirectionalLight& sun) {
        return sun.direction.y > 0.1f * glm::length(sun.direction);
    });
}

void judgeTrials(Judgement& j) {
    const Lighting& l = j.input.lighting;
    const FrameEvidence& e = j.evidence;
    if (e.revives(Trial::lightsTurned))
        j.add(Cause::lightDirection, anySunRises(l) ? 0.95f : 0.93f,
              (l.directional.empty()
                   ? std::string("The spots and flat lights shine away from what is seen")
                   : "The sun travels along " + text(l.directional[0].direction)) +
                  "; turned round, the frame is fine.",
              "A light's direction is the way that it travels, not the way towards it: negate it.");
    if (e.revives(Trial::noShadows))
        j.add(
            Cause::shadowed, 0.94f,
            std::to_string(e.report.shadowViewsDrawn + e.report.shadowViewsCached) +
                " shadow maps hide all light from what is seen; without shadows the frame is fine.",
            "Look for an object around the scene or between it and the light that should not cast "
            "shadows "
            "(clear kInstanceCastsShadow), or add ambient light.");
    if (e.revives(Trial::noFog))
        j.add(Cause::fog, 0.96f,
              "The fog's density is " + number(l.fog.density) + " per metre, which hides " +
                  percent(e.look.veiled) + " of the surfaces; without it the frame is fine.",
              "Lower Fog::density: 1 / density is the distance in metres at which 37 % of the "
              "light is left.");
    if (e.revives(Trial::frameShown))
        j.add(Cause::shownImage, 0.99f,
              std::string("FrameSettings::debugView asks for \"") +
                  toText(j.input.settings.debugView) + "\", not for the frame.",
              "Set FrameSettings::debugView to DebugView::none.");
}

}  // namespace

void judgeMaterials(Judgement& j) {
    const FrameEvidence& e = j.evidence;
    uint32_t black = 0;
    for (const MaterialDesc& m : e.materials) black += peak(vec3(m.baseColor)) < 0.01f;
    if (e.surface.baseColor < 0.02f && e.revives(Trial::whiteMaterials) &&
        !e.of(Trial::whiteMaterials).look.isMostlyBlack())
        j.add(Cause::blackMaterials, 0.95f,
              "The base colours in view are at most " + number(e.surface.baseColor) + " (" +
                  std::to_string(black) + " of " + std::to_string(e.materials.size()) +
                  " objects have a black factor, the others a black texture or black vertex "
                  "colours); in white the frame is fine.",
              "Check the base colour factor and its texture: whether it was found and decoded, and "
              "whether the texture coordinates hit it.");
    else if (e.surface.metallic > 0.5f && e.revives(Trial::noMetals) &&
             !e.of(Trial::noMetals).look.isMostlyBlack())
        j.add(
            Cause::mirrorsNothing, 0.95f,
            "What is in view is metal by " + percent(e.surface.metallic) +
                ", and a metal shows only what it mirrors" +
                (hasAmbientLight(j.input.lighting) ? ""
                                                   : "; there is no ambient light to be mirrored") +
                ". Without metal the frame is fine.",
            "Add an environment or ambient light, or set metallic to 0 where no metal is meant; "
            "glTF's default is 1.");
}

bool hasAmbientLight(const Lighting& l) {
    const bool environment = l.environment && l.environmentIntensity > 0;
    return environment || l.irradianceVolume || !l.reflectionProbes.empty() ||
           peak(l.ambientSky) > 0 || peak(l.ambientGround) > 0;
}

void judgeLights(Judgement& j) {
    const Lighting& l = j.input.lighting;
    if (hasAmbientLight(l) || anythingGlows(j.evidence)) return judgeReach(j);
    if (brightestLight(l) > 0) return judgeReach(j);
    j.add(Cause::noLights, 0.98f,
          lightCount(l) == 0
              ? "The frame has no lights, no ambient light, and nothing in it glows."
              : "All " + std::to_string(lightCount(l)) +
                    " lights have an intensity of 0; there is no ambient light, and nothing glows.",
          "Add a light or an environment (Lighting::directional, punctual, area, environment or "
          "ambientSky).");
}

void judgeLook(Judgement& j) {
    const FrameLook& look = j.evidence.look;
    if (look.notFinite >= 0.001f)
        j.add(Cause::notFinite, 0.98f,
              percent(look.notFinite) + " of the pixels are NaN or infinite before exposure.",
              "Look for materials, lights or an environment with values that are not finite.");
    judgeTrials(j);
    if (look.isBlack()) judgeMaterials(j);
}

// EV100 by Lagarde and de Rousiers 2014, as exposureFactor() has it. A value that a camera could
// have been set to speaks for the exposure, and then the lights are too weak for it; so does a
// plain factor of 1.
void judgeExposure(Judgement& j) {
    const FrameEvidence& e = j.evidence;
    const FrameSettings& s = j.input.settings;
    if (!e.revives(Trial::suitedExposure) || s.autoExposure) return;
    const auto valueOf = [](double factor) {
        return std::log2(1 / (1.2 * std::max(factor, 1e-30)));
    };
    const double now = valueOf(double(e.exposureFactor)),
                 suits = valueOf(0.18 / double(e.look.typical));
    const double off = now - suits;  // stops; > 0: too dark
    const std::string evidence = "The picture is exposed for EV100 " + number(now) +
                                 " (a factor of " + number(double(e.exposureFactor)) +
                                 "); the radiance in view, typically " +
                                 number(double(e.look.typical)) + ", suits EV100 " + number(suits) +
                                 ".";
    const bool usual = s.useExposureValue ? now > -6.5 && now < 17.5
                                          : s.exposureScale > 1e-3f && s.exposureScale < 1e3f;
    const bool weak = off > 0 && usual;
    if (std::abs(off) < 3) return;
    const std::string factor = number(0.18 / double(e.look.typical));
    j.add(Cause::exposure, weak ? 0.6f : 0.92f, evidence,
          "Set FrameSettings::exposureValue to about " + number(std::round(suits)) +
              ", or exposureScale to about " + factor + ", or use autoExposure.");
    if (off > 0)
        j.add(Cause::lightsTooWeak, weak ? 0.9f : 0.5f,
              evidence + " The brightest light has " +
                  number(double(brightestLight(j.input.lighting))) + ".",
              "Give lights in photometric units: lux for suns (100,000 by day), candela for points "
              "and spots (100 a "
              "household bulb), candela per square metre for areas; or lower the exposure value.");
}

}  // namespace rushlight

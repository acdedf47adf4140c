#include "renderer/answers/trials.h"

#include <algorithm>
#include <utility>

namespace rushlight {
namespace {

/// Each instance in a material of its own, made from what it had.
template <class F>
void remake(const FrameEvidence& evidence, TrialMaterials& materials, EditableFrame& frame,
            F&& change) {
    struct Made {
        MaterialHandle from, to;
    };
    std::vector<Made> known;
    for (size_t i = 0; i < frame.instances.size(); ++i) {
        const MaterialHandle from = evidence.instances[i].instance.material;
        auto found = std::ranges::find(known, from, &Made::from);
        if (found == known.end()) {
            const auto made = materials.create(change(evidence.materials[i]));
            known.push_back({from, made ? *made : from});
            found = known.end() - 1;
        }
        frame.instances[i].material = found->to;
    }
}

MaterialDesc white(const MaterialDesc& from) {
    MaterialDesc desc;
    desc.label = "white";
    desc.baseColor = vec4(vec3(0.8f), 1);
    desc.metallic = 0;
    desc.doubleSided = from.doubleSided;
    return desc;
}

bool turnLights(EditableFrame& frame) {
    bool any = false;
    for (DirectionalLight& light : frame.directional)
        light.direction = -light.direction, any = true;
    for (PunctualLight& light : frame.punctual)
        if (light.outerConeAngle >= 0) light.direction = -light.direction, any = true;
    for (AreaLight& light : frame.area)
        if (!light.twoSided && light.shape <= AreaShape::disk)
            light.halfX = -light.halfX, any = true;
    return any;
}

bool unbindLights(EditableFrame& frame) {
    bool any = false;
    for (PunctualLight& light : frame.punctual) any |= light.range > 0, light.range = 0;
    for (AreaLight& light : frame.area) any |= light.range > 0, light.range = 0;
    return any;
}

bool freeEye(const FrameEvidence& evidence, EditableFrame& frame) {
    const vec3 eye = eyeOf(frame.view());
    std::vector<Instance> kept;
    for (size_t i = 0; i < frame.instances.size(); ++i)
        if (!surroundsEye(evidence, i, eye)) kept.push_back(frame.instances[i]);
    const bool any = kept.size() < frame.instances.size() && !kept.empty();
    frame.instances = std::move(kept);
    return any;
}

bool change(Trial trial, const FrameEvidence& evidence, TrialMaterials& materials,
            EditableFrame& frame) {
    switch (trial) {
        case Trial::frameShown:
            return std::exchange(frame.settings().debugView, DebugView::none) != DebugView::none;
        case Trial::noFog: return std::exchange(frame.lighting().fog, Fog{}).density > 0;
        case Trial::noShadows: return std::exchange(frame.settings().shadows, false);
        case Trial::lightsTurned: return turnLights(frame);
        case Trial::lightsUnbounded: return unbindLights(frame);
        case Trial::whiteMaterials: remake(evidence, materials, frame, white); return true;
        case Trial::doubleSided:
            remake(evidence, materials, frame, [](const MaterialDesc& from) {
                MaterialDesc desc = white(from);
                desc.doubleSided = true;
                return desc;
            });
            return true;
        case Trial::noMetals:
            remake(evidence, materials, frame, [](MaterialDesc desc) {
                desc.label = "no metal";
                desc.metallic = 0;
                return desc;
            });
            return true;
        case Trial::suitedExposure:
            frame.settings().autoExposure = frame.settings().useExposureValue = false;
            frame.settings().exposureScale = 0.18f / evidence.look.typical;
            return evidence.look.typical > 0;
        case Trial::planesApart:
            if (!frame.view().perspective) return false;
            frame.view().nearPlane = std::min(frame.view().nearPlane, 1e-3f);
            frame.view().farPlane = 0;
            return true;
        case Trial::usualFieldOfView:
            if (!frame.view().perspective || frame.view().verticalFov > 0.1f) return false;
            frame.view().verticalFov = 0.785f;
            return true;
        case Trial::eyeFreed: return freeEye(evidence, frame);
        case Trial::noOcclusionCulling:
            return std::exchange(frame.settings().occlusionCulling, false);
        case Trial::count: break;
    }
    return false;
}

}  // namespace

vec3 eyeOf(const View& view) { return vec3(glm::inverse(view.viewFromWorld)[3]); }

bool holds(const Aabb& box, const vec3& point) {
    const vec3 inside = box.halfExtent() - glm::abs(point - box.center());
    return std::min({inside.x, inside.y, inside.z}) > 0;
}

bool surroundsEye(const FrameEvidence& evidence, size_t instance, const vec3& eye) {
    const InstanceFacts& at = evidence.instances[instance];
    if (at.rejected || !holds(at.bounds, eye)) return false;
    size_t others = 0, within = 0;
    for (size_t i = 0; i < evidence.instances.size(); ++i) {
        if (i == instance || evidence.instances[i].rejected) continue;
        ++others;
        within += holds(at.bounds, evidence.instances[i].bounds.center());
    }
    return 2 * within < std::max<size_t>(others, 1);
}

std::optional<EditableFrame> makeTrial(Trial trial, const FrameInput& input,
                                       const FrameEvidence& evidence, TrialMaterials& materials) {
    EditableFrame frame(input, evidence.instances);
    if (!change(trial, evidence, materials, frame)) return {};
    return frame;
}

}  // namespace rushlight

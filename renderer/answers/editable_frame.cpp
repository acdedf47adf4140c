#include "renderer/answers/editable_frame.h"

#include "renderer/lighting/clusters/light_clusters.h"

namespace rushlight {

EditableFrame::EditableFrame(const FrameInput& from)
    : instances(from.instances.begin(), from.instances.end()),
      directional(from.lighting.directional.begin(), from.lighting.directional.end()),
      punctual(from.lighting.punctual.begin(), from.lighting.punctual.end()),
      area(from.lighting.area.begin(), from.lighting.area.end()),
      frame_(from) {
    frame_.overlay = {};
}

EditableFrame::EditableFrame(const FrameInput& from, std::span<const InstanceFacts> facts)
    : EditableFrame(from) {
    frame_.world = {};
    instances.clear();
    for (const InstanceFacts& f : facts) {
        instances.push_back(f.instance);
        if (f.kept)
            instances.back().flags &= ~uint32_t(kInstanceMoving);  // from where is not known
    }
}

FrameInput EditableFrame::input() const {
    FrameInput input = frame_;
    input.instances = instances;
    input.lighting.directional = directional;
    input.lighting.punctual = punctual;
    input.lighting.area = area;
    return input;
}

void EditableFrame::removeAmbientLight() {
    Lighting& l = frame_.lighting;
    l.environment = {};
    l.ambientSky = l.ambientGround = vec3(0);
    l.irradianceVolume = {};
    l.reflectionProbes = {};
    if (l.background == Background::environment) l.background = Background::color;
}

// A range that follows from the intensity is kept: what a light reaches decides over its shadow and
// its froxels.
void EditableFrame::darkenLights() {
    for (DirectionalLight& light : directional) light.illuminance = vec3(0);
    for (PunctualLight& light : punctual) {
        light.range = effectiveRange(light);
        light.intensity = vec3(0);
    }
    for (AreaLight& light : area) {
        light.range = effectiveRange(light);
        light.luminance = vec3(0);
    }
}

Result<CapturedImage> Shots::take(const FrameInput& input, CaptureKind kind) {
    const auto ticket = renderer_.renderOffscreen(input, size_.x, size_.y, kind, {.timers = false});
    if (!ticket) return tl::unexpected(ticket.error());
    CapturedImage image;
    if (!renderer_.takeCapture(*ticket, true, image))
        return fail("capture", "the context was lost.", ErrorKind::noContext);
    return image;
}

Result<CapturedImage> Shots::take(FrameInput input, DebugView show, CaptureKind kind) {
    input.settings.debugView = show;
    return take(input, kind);
}

Result<MaterialHandle> TrialMaterials::invisible() {
    if (invisible_) return invisible_;
    MaterialDesc desc;
    desc.label = "invisible";
    desc.baseColor = vec4(0);
    desc.alphaMode = AlphaMode::mask;
    const auto made = create(desc);
    if (made) invisible_ = *made;
    return made;
}

}  // namespace rushlight

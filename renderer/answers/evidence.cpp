#include "renderer/answers/trials.h"
#include "renderer/passes/post/tonemap_pass.h"

namespace rushlight {
namespace {

class Gatherer {
public:
    Gatherer(Renderer& renderer, const FrameInput& input, uvec2 size)
        : input_(input), shots_(renderer, size), materials_(renderer) {
        evidence_.size = size;
    }

    FrameEvidence run() {
        if (auto ok = gather(); !ok) evidence_.refusal = ok.error();
        return std::move(evidence_);
    }

private:
    Result<void> gather();
    Result<FrameLook> look(const FrameInput& frame);
    Result<void> lookAtSurface();
    Result<void> takeTrials();

    const FrameInput& input_;
    Shots shots_;
    TrialMaterials materials_;
    FrameEvidence evidence_;
};

Result<void> Gatherer::gather() {
    if (evidence_.size.x == 0 || evidence_.size.y == 0)
        return fail("frame target", "it has no size.", ErrorKind::wrongUse);
    if (auto shown = shots_.take(input_, CaptureKind::display); !shown)
        return tl::unexpected(shown.error());
    Renderer& renderer = shots_.renderer();
    evidence_.report = renderer.report();
    evidence_.instances = renderer.describeInstances();
    for (const InstanceFacts& facts : evidence_.instances)
        evidence_.materials.push_back(
            renderer.describeMaterial(facts.instance.material).value_or(MaterialDesc{}));
    evidence_.exposureFactor = exposureFactor(input_.settings);
    evidence_.hasPictures = renderer.deviceName() != "null";
    if (!evidence_.hasPictures) return {};
    const auto found = look(input_);
    if (!found) return tl::unexpected(found.error());
    evidence_.look = *found;
    if (evidence_.instances.empty() || (found->isFine() && !found->isMostlyBlack())) return {};
    if (auto ok = lookAtSurface(); !ok) return ok;
    return takeTrials();
}

Result<FrameLook> Gatherer::look(const FrameInput& frame) {
    EditableFrame background(frame);
    background.instances.clear();
    FrameInput nothing = background.input();
    nothing.world = {};
    nothing.settings.debugView = DebugView::none;
    FrameInput whole = frame;
    whole.settings.debugView = DebugView::none;
    const auto display = shots_.take(frame, CaptureKind::display);
    if (!display) return tl::unexpected(display.error());
    const auto linear = shots_.take(whole, CaptureKind::hdr);
    if (!linear) return tl::unexpected(linear.error());
    const auto empty = shots_.take(nothing, CaptureKind::hdr);
    if (!empty) return tl::unexpected(empty.error());
    const auto depth = shots_.take(frame, DebugView::depth, CaptureKind::hdr);
    if (!depth) return tl::unexpected(depth.error());
    FrameLook look = lookOf({&*display, &*linear, &*empty, &*depth}, !evidence_.instances.empty());
    look.veiled = veiledBy(frame.lighting.fog, frame.view, *depth);
    return look;
}

Result<void> Gatherer::lookAtSurface() {
    const auto color = shots_.take(input_, DebugView::baseColor);
    if (!color) return tl::unexpected(color.error());
    const auto metallic = shots_.take(input_, DebugView::metallic);
    if (!metallic) return tl::unexpected(metallic.error());
    const auto depth = shots_.take(input_, DebugView::depth, CaptureKind::hdr);
    if (!depth) return tl::unexpected(depth.error());
    evidence_.surface = surfaceOf(*color, *metallic, *depth);
    return {};
}

Result<void> Gatherer::takeTrials() {
    for (size_t i = 0; i < evidence_.trials.size(); ++i) {
        const auto trial = makeTrial(Trial(i), input_, evidence_, materials_);
        if (!trial) continue;
        const auto found = look(trial->input());
        if (!found) return tl::unexpected(found.error());
        evidence_.trials[i] = {true, *found};
    }
    return {};
}

}  // namespace

FrameEvidence gatherEvidence(Renderer& renderer, const FrameInput& input, uvec2 size) {
    return Gatherer(renderer, input, size).run();
}

}  // namespace rushlight

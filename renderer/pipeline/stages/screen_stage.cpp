#include "renderer/pipeline/stages/screen_stage.h"

#include "renderer/passes/screen/screen_uniforms.h"

namespace rushlight {

Result<ImageId> ScreenStage::addReflections(FrameContext& frame, const Inputs& inputs) {
    const LightingStage::Outputs& lit = *inputs.lit;
    const bool alone = frame.plan.wants("reflections");
    const bool mirrors = frame.settings().reflections && frame.settings().ambientReflections;
    if (!alone && !mirrors) return lit.radiance;
    const uint32_t width = frame.width(), height = frame.height();
    const interop::ScreenUniforms screen = makeScreenUniforms(frame.camera, width, height);
    const auto pyramid = pyramidPass_.add(
        frame.plan, {lit.radiance, inputs.gbuffer->depth, screen, &frame.uploads, width, height});
    if (!pyramid) return tl::unexpected(pyramid.error());
    ReflectionsPass::Inputs in{*inputs.gbuffer, lit.lighting,  lit.ambientOcclusion,
                               lit.localTint,   lit.localFlow, *pyramid,
                               screen,          lit.radiance,  alone,
                               &frame.uploads,  width,         height};
    if (alone) {
        const auto made = reflectionsPass_.add(frame.plan, in);
        if (!made) return tl::unexpected(made.error());
        frame.plan.publish("reflections", made->radiance);
    }
    if (!mirrors) return lit.radiance;
    in.alone = false;
    const auto made = reflectionsPass_.add(frame.plan, in);
    if (!made) return tl::unexpected(made.error());
    return made->radiance;
}

Result<ImageId> ScreenStage::addFog(FrameContext& frame, const Inputs& inputs, ImageId radiance) {
    const bool alone = frame.plan.wants("fog");
    const bool covers = frame.input.lighting.fog.density > 0;
    if (!alone && !covers) return ImageId{};
    LightingBindings around = inputs.lit->lighting;
    around.features.reflectionProbes = false;  // air mirrors nothing
    const FogGrid& grid = inputs.lit->fog;
    const auto fog = fogPass_.add(frame.plan, {around, grid});
    if (!fog) return tl::unexpected(fog.error());
    FogPass::Target target{fog->fog,        radiance, inputs.gbuffer->depth,
                           around.uniforms, false,    around.features.orthographic};
    if (covers)
        if (auto ok = fogPass_.apply(frame.plan, target); !ok) return tl::unexpected(ok.error());
    if (alone) {
        target.radiance = frame.plan.createImage(
            {"fog-alone", Format::rgba16f, grid.width, grid.height});
        target.clear = true;
        if (auto ok = fogPass_.apply(frame.plan, target); !ok) return tl::unexpected(ok.error());
        frame.plan.publish("fog", target.radiance);
    }
    return covers ? fog->fog : ImageId{};
}

Result<ScreenStage::Outputs> ScreenStage::add(FrameContext& frame, const Inputs& inputs) {
    const auto radiance = addReflections(frame, inputs);
    if (!radiance) return tl::unexpected(radiance.error());
    const auto fog = addFog(frame, inputs, *radiance);
    if (!fog) return tl::unexpected(fog.error());
    return Outputs{*radiance, *fog};
}

}  // namespace rushlight

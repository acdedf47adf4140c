#include "renderer/answers/explain.h"

#include "interop/tonemap.h"
#include "renderer/answers/light_shares.h"
#include "renderer/answers/surface_finder.h"
#include "renderer/geometry/view_math.h"
#include "renderer/passes/post/tonemap_pass.h"

#include <algorithm>

namespace rushlight {
namespace {

/// Bilinear, as a linear sampler that clamps reads it at the pixel's centre of a picture of `size`.
vec3 sampleAt(const CapturedImage& image, uvec2 pixel, uvec2 size) {
    const vec2 at = (vec2(pixel) + 0.5f) / vec2(size) * vec2(image.width, image.height) - 0.5f;
    const vec2 low = glm::floor(at), share = at - low;
    const auto texel = [&](float x, float y) {
        return colorAt(image, {uint32_t(std::clamp(low.x + x, 0.0f, float(image.width - 1))),
                               uint32_t(std::clamp(low.y + y, 0.0f, float(image.height - 1)))});
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), share.x),
                    glm::mix(texel(0, 1), texel(1, 1), share.x), share.y);
}

class Explainer {
public:
    Explainer(Renderer& renderer, const FrameInput& input, uvec2 size,
              std::span<const uvec2> pixels)
        : input_(input), shots_(renderer, size), materials_(renderer), result_(pixels.size()) {
        input_.overlay = {};
        input_.settings.debugView = DebugView::none;
        for (size_t i = 0; i < pixels.size(); ++i) result_[i].pixel = pixels[i];
    }

    Result<std::vector<PixelExplanation>> run() {
        for (const auto step :
             {&Explainer::takeShown, &Explainer::findSurfaces, &Explainer::readGBuffer,
              &Explainer::peelOff, &Explainer::splitAmbient, &Explainer::splitLights,
              &Explainer::readBloom, &Explainer::findExposure})
            if (auto ok = (this->*step)(); !ok) return tl::unexpected(ok.error());
        for (PixelExplanation& pixel : result_) addUp(pixel, input_, shots_.size());
        return std::move(result_);
    }

private:
    Result<void> takeShown();
    Result<void> findSurfaces();
    Result<void> readGBuffer();
    Result<void> peelOff();
    Result<void> hideBlended();
    Result<void> splitAmbient();
    Result<void> splitLights() { return addLightShares(shots_, *plain_, std::span(result_)); }
    Result<void> readBloom();
    Result<void> findExposure();
    Result<float> measureExposure();
    void placeSurfaces(const CapturedImage& depth);

    FrameInput input_;
    Shots shots_;
    TrialMaterials materials_;
    std::vector<PixelExplanation> result_;
    std::vector<InstanceFacts> facts_;
    std::optional<EditableFrame> plain_;  ///< the frame with nothing over its opaque surfaces
    bool hasBlended_ = false;
    CapturedImage linear_;  ///< the whole frame
    std::optional<CapturedImage> bloom_;
};

// The first frame lets levels of detail and shadow maps settle.
Result<void> Explainer::takeShown() {
    if (auto warm = shots_.take(input_, CaptureKind::display); !warm)
        return tl::unexpected(warm.error());
    input_.settings.deltaTime = 0;  // exposure that adapts stays as it is
    facts_ = shots_.renderer().describeInstances();
    const auto shown = shots_.take(input_, CaptureKind::display);
    if (!shown) return tl::unexpected(shown.error());
    const auto before = shots_.take(input_, DebugView::tonemap);
    if (!before) return tl::unexpected(before.error());
    for (PixelExplanation& pixel : result_) {
        const uint8_t* codes = codesAt(*shown, pixel.pixel);
        const uint8_t* unfiltered = codesAt(*before, pixel.pixel);
        std::copy_n(codes, 4, pixel.shown.begin());
        for (int c = 0; c < 3; ++c)
            pixel.antiAliasing[c] = float(int(codes[c]) - int(unfiltered[c])) / 255;
    }
    return {};
}

Result<void> Explainer::findSurfaces() {
    const auto depth = shots_.take(input_, DebugView::depth, CaptureKind::hdr);
    if (!depth) return tl::unexpected(depth.error());
    placeSurfaces(*depth);
    if (facts_.empty()) return {};
    SurfaceFinder finder(shots_, input_, facts_);
    hasBlended_ = finder.hasBlended();
    const auto opaque = finder.find(false);
    if (!opaque) return tl::unexpected(opaque.error());
    const auto all = hasBlended_ ? finder.find(true) : opaque;
    if (!all) return tl::unexpected(all.error());
    for (PixelExplanation& pixel : result_) {
        const size_t at = size_t(pixel.pixel.y) * shots_.size().x + pixel.pixel.x;
        const uint32_t seen = (*opaque)[at], nearest = (*all)[at];
        if (pixel.surface && seen != SurfaceFinder::kNone) pixel.surface->object = facts_[seen];
        if (nearest != seen && nearest != SurfaceFinder::kNone) pixel.blended = facts_[nearest];
    }
    return {};
}

void Explainer::placeSurfaces(const CapturedImage& depth) {
    const uvec2 size = shots_.size();
    const auto camera = makeCamera(input_.view, float(size.x) / float(size.y));
    for (PixelExplanation& pixel : result_) {
        const float d = colorAt(depth, pixel.pixel).x;
        if (!(d > 0)) continue;
        PixelSurface& surface = pixel.surface.emplace();
        const float linear = d * camera->depthDecode.x + camera->depthDecode.y;
        surface.viewDepth = camera->perspective ? 1 / linear : linear;
        const vec2 uv((float(pixel.pixel.x) + 0.5f) / float(size.x),
                      1 - (float(pixel.pixel.y) + 0.5f) / float(size.y));
        surface.position = camera->position + camera->relativePosition(uv, surface.viewDepth);
    }
}

Result<void> Explainer::readGBuffer() {
    const auto read = [&](DebugView show, auto&& store) -> Result<void> {
        const auto image = shots_.take(input_, show);
        if (!image) return tl::unexpected(image.error());
        for (PixelExplanation& pixel : result_) {
            const uint8_t* codes = codesAt(*image, pixel.pixel);
            if (pixel.surface) store(*pixel.surface, vec3(codes[0], codes[1], codes[2]) / 255.0f);
        }
        return {};
    };
    Result<void> ok = read(DebugView::baseColor, [](PixelSurface& s, const vec3& v) {
        s.baseColor = interop::decodeSrgb(v);
    });
    if (ok)
        ok = read(DebugView::metallic, [](PixelSurface& s, const vec3& v) { s.metallic = v.x; });
    if (ok)
        ok = read(DebugView::roughness, [](PixelSurface& s, const vec3& v) { s.roughness = v.x; });
    if (ok)
        ok = read(DebugView::occlusion, [](PixelSurface& s, const vec3& v) { s.occlusion = v.x; });
    if (ok)
        ok = read(DebugView::normal, [](PixelSurface& s, const vec3& v) {
            s.normal = glm::normalize(v * 2.0f - 1.0f);
        });
    return ok;
}

Result<void> Explainer::hideBlended() {
    const auto invisible = materials_.invisible();
    if (!invisible) return tl::unexpected(invisible.error());
    plain_.emplace(input_, facts_);
    for (Instance& instance : plain_->instances) {
        const auto desc = shots_.renderer().describeMaterial(instance.material);
        if (desc && desc->alphaMode == AlphaMode::blend) instance.material = *invisible;
    }
    return {};
}

// From the whole frame inwards: what each layer adds is the difference that it makes.
Result<void> Explainer::peelOff() {
    auto whole = shots_.take(input_, CaptureKind::hdr);
    if (!whole) return tl::unexpected(whole.error());
    linear_ = *whole;
    const auto peel = [&](vec3 PixelExplanation::*part) -> Result<void> {
        auto under = shots_.take(plain_->input(), CaptureKind::hdr);
        if (!under) return tl::unexpected(under.error());
        for (PixelExplanation& p : result_)
            p.*part = colorAt(*whole, p.pixel) - colorAt(*under, p.pixel);
        whole = std::move(under);
        return {};
    };
    plain_.emplace(input_);
    Result<void> ok;
    if (hasBlended_) ok = hideBlended();
    if (ok && hasBlended_) ok = peel(&PixelExplanation::blendedSurfaces);
    const bool fog = plain_->lighting().fog.density > 0;
    plain_->lighting().fog = {};
    if (ok && fog) ok = peel(&PixelExplanation::fog);
    const bool mirrors = plain_->settings().reflections;
    plain_->settings().reflections = false;
    if (ok && mirrors) ok = peel(&PixelExplanation::reflections);
    if (!ok) return ok;
    for (PixelExplanation& p : result_) {
        const size_t at = size_t(p.pixel.y) * linear_.width + p.pixel.x;
        if (input_.lighting.background == Background::transparent)
            p.alpha = linear_.rgba32f[at * 4 + 3];
        if (!p.surface) p.background = colorAt(*whole, p.pixel);
    }
    return {};
}

Result<void> Explainer::splitAmbient() {
    EditableFrame frame = *plain_;
    frame.darkenLights();
    const auto ambient = shots_.take(frame.input(), CaptureKind::hdr);
    if (!ambient) return tl::unexpected(ambient.error());
    frame.settings().ambientReflections = false;
    const auto diffuse = shots_.take(frame.input(), CaptureKind::hdr);
    if (!diffuse) return tl::unexpected(diffuse.error());
    frame.settings().ambientReflections = true;
    const bool occluded = frame.settings().ambientOcclusion != AmbientOcclusion::off;
    frame.settings().ambientOcclusion = AmbientOcclusion::off;
    const auto open = occluded ? shots_.take(frame.input(), CaptureKind::hdr) : ambient;
    if (!open) return tl::unexpected(open.error());
    frame.removeAmbientLight();
    const auto emissive = shots_.take(frame.input(), CaptureKind::hdr);
    if (!emissive) return tl::unexpected(emissive.error());
    for (PixelExplanation& p : result_) {
        if (!p.surface) continue;
        p.emissive = colorAt(*emissive, p.pixel);
        p.ambientDiffuse = colorAt(*diffuse, p.pixel) - p.emissive;
        p.ambientSpecular = colorAt(*ambient, p.pixel) - colorAt(*diffuse, p.pixel);
        const float all = interop::luminance(colorAt(*open, p.pixel) - p.emissive);
        if (all > 0)
            p.ambientVisibility = interop::luminance(p.ambientDiffuse + p.ambientSpecular) / all;
    }
    return {};
}

Result<void> Explainer::readBloom() {
    if (!input_.settings.bloom) return {};
    auto bloom = shots_.take(input_, DebugView::bloom, CaptureKind::hdr);
    if (!bloom) return tl::unexpected(bloom.error());
    bloom_ = std::move(*bloom);
    for (PixelExplanation& p : result_)
        p.bloom = (sampleAt(*bloom_, p.pixel, shots_.size()) - colorAt(linear_, p.pixel)) *
                  input_.settings.bloomStrength;
    return {};
}

// An exposure that the GPU found is measured: the factor between the linear picture and one that is
// displayed untouched.
Result<float> Explainer::measureExposure() {
    FrameInput untouched = input_;
    untouched.settings.toneMap = ToneMap::none;
    untouched.settings.dither = false;
    const auto image = shots_.take(untouched, DebugView::tonemap);
    if (!image) return tl::unexpected(image.error());
    const uvec2 size = shots_.size();
    std::vector<float> factors;
    for (uint32_t y = 0; y < size.y; ++y)
        for (uint32_t x = 0; x < size.x; ++x) {
            const uint8_t code = codesAt(*image, {x, y})[1];
            float radiance = colorAt(linear_, {x, y}).y;
            if (bloom_)
                radiance = glm::mix(radiance, sampleAt(*bloom_, {x, y}, size).y,
                                    input_.settings.bloomStrength);
            if (code >= 40 && code <= 250 && radiance > 0)
                factors.push_back(interop::decodeSrgb(float(code) / 255) / radiance);
        }
    if (factors.empty()) return 1.0f;
    const auto middle = factors.begin() + std::ptrdiff_t(factors.size() / 2);
    std::ranges::nth_element(factors, middle);
    return *middle;
}

Result<void> Explainer::findExposure() {
    float exposure = exposureFactor(input_.settings);
    if (input_.settings.autoExposure) {
        const auto measured = measureExposure();
        if (!measured) return tl::unexpected(measured.error());
        exposure = *measured;
    }
    for (PixelExplanation& p : result_) {
        p.exposure = exposure;
        p.toneMap = input_.settings.toneMap;
    }
    return {};
}

}  // namespace

Result<std::vector<PixelExplanation>> explain(Renderer& renderer, const FrameInput& input,
                                              uvec2 size, std::span<const uvec2> pixels) {
    for (const uvec2 pixel : pixels)
        if (pixel.x >= size.x || pixel.y >= size.y)
            return fail("pixel " + std::to_string(pixel.x) + "," + std::to_string(pixel.y),
                        "It is outside of the picture, which is " + std::to_string(size.x) + "x" +
                            std::to_string(size.y) + ".",
                        ErrorKind::wrongUse);
    return Explainer(renderer, input, size, pixels).run();
}

}  // namespace rushlight

#include "renderer/answers/surface_finder.h"

#include <algorithm>

namespace rushlight {

bool SurfaceFinder::hasBlended() const {
    return std::ranges::any_of(facts_, [&](const InstanceFacts& facts) {
        const auto desc = shots_.renderer().describeMaterial(facts.instance.material);
        return desc && desc->alphaMode == AlphaMode::blend;
    });
}

Result<MaterialHandle> SurfaceFinder::digitMaterial(MaterialHandle original, uint32_t digit,
                                                    bool withBlended) {
    for (const Painted& known : painted_)
        if (known.original == original && known.digit == digit && known.withBlended == withBlended)
            return known.material;
    const auto from = shots_.renderer().describeMaterial(original);
    if (!from) return original;  // stale: its instances are not drawn
    MaterialDesc desc;
    desc.label = "number";
    desc.doubleSided = from->doubleSided;
    desc.metallic = float(digit) / float(kDigits - 1);
    if (from->alphaMode != AlphaMode::opaque) {
        desc.alphaMode = AlphaMode::mask;
        desc.alphaCutoff = from->alphaCutoff;
        desc.baseColor = from->baseColor;
        desc.baseColorTexture = from->baseColorTexture;
    }
    if (from->alphaMode == AlphaMode::blend) desc.alphaCutoff = 0.5f / 255;
    const bool hidden = from->alphaMode == AlphaMode::blend && !withBlended;
    const auto made = hidden ? materials_.invisible() : materials_.create(desc);
    if (made) painted_.push_back({original, digit, withBlended, *made});
    return made;
}

Result<void> SurfaceFinder::paint(EditableFrame& frame, uint32_t digitPlace, bool withBlended) {
    for (uint32_t i = 0; i < facts_.size(); ++i) {
        const uint32_t digit = i / digitPlace % kDigits;
        const auto material = digitMaterial(facts_[i].instance.material, digit, withBlended);
        if (!material) return tl::unexpected(material.error());
        frame.instances[i].material = *material;
    }
    return {};
}

Result<std::vector<uint32_t>> SurfaceFinder::find(bool withBlended) {
    EditableFrame frame(input_, facts_);
    frame.removeDecals();
    std::vector<uint32_t> numbers(size_t(shots_.size().x) * shots_.size().y, 0);
    uint32_t place = 1;
    do {
        if (auto ok = paint(frame, place, withBlended); !ok) return tl::unexpected(ok.error());
        const auto image = shots_.take(frame.input(), DebugView::metallic);
        if (!image) return tl::unexpected(image.error());
        for (size_t i = 0; i < numbers.size(); ++i)
            numbers[i] += (image->rgba8[i * 4] * (kDigits - 1) + 127) / 255 * place;
        place *= kDigits;
    } while (place < facts_.size());
    const auto depth = shots_.take(frame.input(), DebugView::depth, CaptureKind::hdr);
    if (!depth) return tl::unexpected(depth.error());
    for (size_t i = 0; i < numbers.size(); ++i)
        if (!(depth->rgba32f[i * 4] > 0) || numbers[i] >= facts_.size()) numbers[i] = kNone;
    return numbers;
}

}  // namespace rushlight

#include "renderer/resources/texture_store.h"

#include "renderer/materials/mip_chain.h"

#include <algorithm>
#include <utility>

namespace rushlight {

TextureStore::~TextureStore() {
    for (const Array& array : arrays_)
        if (array.texture) device_.destroy(array.texture);
}

Result<ImageHandle> TextureStore::create(const ImageDesc& desc) {
    const std::string object = "image '" + std::string(desc.label) + "'";
    const std::string size = std::to_string(desc.width) + "x" + std::to_string(desc.height);
    if (desc.width == 0 || desc.height == 0 || desc.width > kMaxSide || desc.height > kMaxSide)
        return fail(object, "its size is " + size + "; each side must be 1 to 16,384 pixels.");
    if (desc.pixels.size() != size_t(desc.width) * desc.height * 4)
        return fail(object, "it has " + std::to_string(desc.pixels.size()) + " bytes but " + size +
                                " RGBA8 needs " +
                                std::to_string(size_t(desc.width) * desc.height * 4) + ".");
    StoredImage image;
    image.shape = {desc.width, desc.height, desc.srgb};
    image.label = desc.label;
    image.levels.emplace_back(desc.pixels.begin(), desc.pixels.end());
    const ImageHandle handle = images_.insert(std::move(image));
    waiting_.push_back(handle);
    return handle;
}

void TextureStore::destroy(ImageHandle handle) {
    const StoredImage* image = images_.find(handle);
    if (!image) return;
    if (image->location.array) {
        Array& array = arrays_[image->arrayIndex];
        if (--array.liveLayers == 0) {
            device_.destroy(array.texture);
            array.texture = {};
        }
        moved_ = true;
    }
    images_.erase(handle);
}

const ImageLocation* TextureStore::find(ImageHandle handle) const {
    const StoredImage* image = images_.find(handle);
    return image ? &image->location : nullptr;
}

Result<bool> TextureStore::flush() {
    if (waiting_.empty()) return std::exchange(moved_, false);
    std::erase_if(waiting_, [&](ImageHandle h) { return !images_.find(h); });
    jobs_.forRanges(uint32_t(waiting_.size()), 1, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) {
            StoredImage& image = *images_.find(waiting_[i]);
            uint32_t width = image.shape.width, height = image.shape.height;
            image.levels.resize(1);  // what did not find room may come again
            while (width > 1 || height > 1) {
                image.levels.push_back(
                    halveImage(image.levels.back(), width, height, image.shape.srgb));
                width = std::max(width / 2, 1u);
                height = std::max(height / 2, 1u);
            }
        }
    });
    std::stable_sort(waiting_.begin(), waiting_.end(), [&](ImageHandle a, ImageHandle b) {
        return images_.find(a)->shape < images_.find(b)->shape;
    });
    for (size_t begin = 0; begin < waiting_.size();) {
        const Shape shape = images_.find(waiting_[begin])->shape;
        size_t end = begin + 1;
        while (end < waiting_.size() && end - begin < kMaxLayers &&
               images_.find(waiting_[end])->shape == shape)
            ++end;
        if (auto ok = uploadGroup(shape, std::span(waiting_).subspan(begin, end - begin)); !ok) {
            waiting_.erase(waiting_.begin(), waiting_.begin() + std::ptrdiff_t(begin));
            moved_ |= begin > 0;
            return tl::unexpected(ok.error());
        }
        begin = end;
    }
    waiting_.clear();
    moved_ = false;
    return true;
}

Result<void> TextureStore::uploadGroup(const Shape& shape, std::span<const ImageHandle> group) {
    TextureDesc desc;
    const std::string label = "textures " + std::to_string(shape.width) + "x" +
                              std::to_string(shape.height) + (shape.srgb ? " srgb" : "");
    desc.label = label;
    desc.kind = TextureKind::texture2dArray;
    desc.format = shape.srgb ? Format::rgba8Srgb : Format::rgba8;
    desc.width = shape.width;
    desc.height = shape.height;
    desc.layers = uint32_t(group.size());
    desc.mipLevels = mipLevelCount(shape.width, shape.height);
    const auto texture = device_.createTexture(desc);
    if (!texture) return tl::unexpected(texture.error());
    for (uint32_t layer = 0; layer < group.size(); ++layer) {
        StoredImage& image = *images_.find(group[layer]);
        for (uint32_t level = 0; level < image.levels.size(); ++level)
            device_.write(*texture,
                          {level, layer, 1, std::max(shape.width >> level, 1u),
                           std::max(shape.height >> level, 1u)},
                          std::as_bytes(std::span(image.levels[level])));
        image.levels = {};
        image.location = {*texture, layer};
        image.arrayIndex = uint32_t(arrays_.size());
    }
    arrays_.push_back({*texture, uint32_t(group.size())});
    return {};
}

}  // namespace rushlight

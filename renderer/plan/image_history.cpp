#include "renderer/plan/image_history.h"

#include <algorithm>
#include <string_view>

namespace rushlight {

ImageHistory::~ImageHistory() {
    for (const Image& image : images_) device_.destroy(image.kept.texture);
}

Result<ImageHistory::Kept> ImageHistory::get(const PlanImage& shape) {
    const auto named = std::ranges::find_if(images_, [&](const Image& image) {
        return std::string_view(image.shape.name) == shape.name;
    });
    if (named != images_.end() && sameShape(named->shape, shape)) return named->kept;
    const auto texture = createTexture(device_, shape);
    if (!texture) return tl::unexpected(texture.error());
    const Image made{shape, {*texture, ++lastGeneration_}};
    if (named == images_.end()) {
        images_.push_back(made);
    } else {
        device_.destroy(named->kept.texture);
        *named = made;
    }
    return made.kept;
}

uint32_t ImageHistory::generationOf(const char* name) const {
    for (const Image& image : images_)
        if (std::string_view(image.shape.name) == name) return image.kept.generation;
    return 0;
}

void ImageHistory::forget() {
    for (Image& image : images_) image.kept.generation = ++lastGeneration_;
}

}  // namespace rushlight

#include "renderer/capture/picture.h"

namespace rushlight {

Picture pictureOf(const PictureView& view) {
    Picture picture;
    picture.width = view.width;
    picture.height = view.height;
    picture.linear = !view.rgba32f.empty();
    picture.description = view.description;
    if (picture.linear) {
        picture.rgba.assign(view.rgba32f.begin(), view.rgba32f.end());
        return picture;
    }
    picture.rgba.resize(view.rgba8.size());
    constexpr float kScale = 1.0f / 255;  // multiplied, as OpenImageIO does: equal pixels are equal
                                          // floats
    for (size_t i = 0; i < picture.rgba.size(); ++i) {
        const float value = float(view.rgba8[i]) * kScale;
        picture.rgba[i] = i % 4 == 3 ? value : value * (float(view.rgba8[i | 3]) * kScale);
    }
    return picture;
}

}  // namespace rushlight

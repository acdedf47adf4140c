#include "engine/core/math.h"
#include "renderer/capture/compare/compare.h"
#include "renderer/capture/image_files.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rushlight {

std::vector<uint8_t> heatMap(const Plane& errors) {
    // Lightness rises in even steps, so that the picture also reads in grey.
    static const std::array kStops = {vec3(0, 0, 0),     vec3(72, 20, 112),  vec3(168, 40, 110),
                                      vec3(236, 96, 64), vec3(252, 176, 72), vec3(255, 255, 224)};
    std::vector<uint8_t> rgba;
    rgba.reserve(errors.values.size() * 4);
    for (double error : errors.values) {
        const float at = float(std::clamp(error, 0.0, 1.0)) * float(kStops.size() - 1);
        const size_t stop = std::min(size_t(at), kStops.size() - 2);
        const vec3 color = glm::mix(kStops[stop], kStops[stop + 1], at - float(stop));
        for (int c = 0; c < 3; ++c) rgba.push_back(uint8_t(std::lround(color[c])));
        rgba.push_back(255);
    }
    return rgba;
}

Result<void> saveHeatMap(const std::string& path, const Plane& errors) {
    const std::vector<uint8_t> colors = heatMap(errors);
    PictureView view;
    view.width = errors.width;
    view.height = errors.height;
    view.rgba8 = colors;
    return saveImage(path, view);
}

}  // namespace rushlight

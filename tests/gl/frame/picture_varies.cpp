// picture_varies FILE MIN: fails unless the standard deviation of the picture's luma is at least
// MIN (of 1).

#include "renderer/capture/image_files.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    const auto picture = rushlight::loadPicture(argv[1]);
    if (!picture) {
        std::fprintf(stderr, "%s\n", picture.error().text().c_str());
        return 3;
    }
    double sum = 0;
    double squares = 0;
    for (size_t i = 0; i < picture->pixelCount(); ++i) {
        const float* p = &picture->rgba[4 * i];
        const double luma = 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
        sum += luma;
        squares += luma * luma;
    }
    const double mean = sum / double(picture->pixelCount());
    const double deviation = std::sqrt(squares / double(picture->pixelCount()) - mean * mean);
    std::printf("%s: %ux%u, mean %.4f, deviation %.4f\n", argv[1], picture->width, picture->height,
                mean, deviation);
    return deviation >= std::atof(argv[2]) ? 0 : 1;
}

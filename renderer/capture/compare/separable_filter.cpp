#include "renderer/capture/compare/separable_filter.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

Plane filteredRows(const Plane& source, const Kernel& kernel) {
    const int radius = int(kernel.size() / 2);
    Plane result(source.width, source.height);
    std::vector<double> row(source.width + 2 * size_t(radius));
    for (uint32_t y = 0; y < source.height; ++y) {
        const double* from = source.values.data() + size_t(y) * source.width;
        std::fill_n(row.begin(), radius, from[0]);
        std::copy_n(from, source.width, row.begin() + radius);
        std::fill_n(row.end() - radius, radius, from[source.width - 1]);
        double* to = result.values.data() + size_t(y) * source.width;
        for (size_t k = 0; k < kernel.size(); ++k)
            for (uint32_t x = 0; x < source.width; ++x) to[x] += kernel[k] * row[x + k];
    }
    return result;
}

Plane filteredColumns(const Plane& source, const Kernel& kernel) {
    const int radius = int(kernel.size() / 2);
    Plane result(source.width, source.height);
    for (int y = 0; y < int(source.height); ++y) {
        double* to = result.values.data() + size_t(y) * source.width;
        for (size_t k = 0; k < kernel.size(); ++k) {
            const int from = std::clamp(y + int(k) - radius, 0, int(source.height) - 1);
            const double* row = source.values.data() + size_t(from) * source.width;
            for (uint32_t x = 0; x < source.width; ++x) to[x] += kernel[k] * row[x];
        }
    }
    return result;
}

}  // namespace

Kernel gaussian(double sigma, int radius) {
    Kernel kernel;
    for (int x = -radius; x <= radius; ++x)
        kernel.push_back(std::exp(-double(x * x) / (2 * sigma * sigma)));
    return kernel;
}

Kernel normalized(Kernel kernel) {
    double sum = 0;
    for (double weight : kernel) sum += weight;
    for (double& weight : kernel) weight /= sum;
    return kernel;
}

Plane filtered(const Plane& source, const Kernel& horizontal, const Kernel& vertical) {
    return filteredColumns(filteredRows(source, horizontal), vertical);
}

}  // namespace rushlight

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rushlight {

/// One value a pixel. Doubles: a variance is the small difference of two means.
struct Plane {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<double> values;

    Plane() = default;
    Plane(uint32_t w, uint32_t h) : width(w), height(h), values(std::size_t(w) * h) {}
};

/// Weights for offsets -radius to +radius.
using Kernel = std::vector<double>;

/// exp(-x²/2σ²) for |x| <= radius, not normalised.
Kernel gaussian(double sigma, int radius);

/// Scaled so that the weights sum to 1.
Kernel normalized(Kernel kernel);

/// Correlates with `horizontal` along rows, then with `vertical` along columns. Beyond its border a
/// picture goes on with its border values.
Plane filtered(const Plane&, const Kernel& horizontal, const Kernel& vertical);

}  // namespace rushlight

#include "renderer/materials/mip_chain.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kLinearSteps = 4096;

struct SrgbTables {
    std::array<uint16_t, 256> toLinear;  // 0 to kLinearSteps - 1
    std::array<uint8_t, kLinearSteps> fromLinear;

    SrgbTables() {
        for (uint32_t i = 0; i < 256; ++i) {
            const double s = i / 255.0;
            const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
            toLinear[i] = uint16_t(std::lround(linear * (kLinearSteps - 1)));
        }
        for (uint32_t i = 0; i < kLinearSteps; ++i) {
            const double x = double(i) / (kLinearSteps - 1);
            const double s = x <= 0.0031308 ? x * 12.92 : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
            fromLinear[i] = uint8_t(std::lround(s * 255));
        }
    }
};

const SrgbTables& srgbTables() {
    static const SrgbTables tables;
    return tables;
}

// What a texel of the smaller level covers along one axis: of an odd size 2m + 1, texel i covers
// (2m + 1) / m texels, three in parts. Guthe and Heckbert, "Non-Power-of-Two Mipmapping", NVIDIA,
// 2005.
struct Taps {
    uint32_t first, count;
    uint32_t weights[3];

    Taps(uint32_t i, uint32_t size)
        : first(2 * i), count(size == 1 ? 1 : 2 + size % 2), weights{1, 1, 0} {
        if (count != 3) return;
        const uint32_t m = size / 2;
        weights[0] = m - i;
        weights[1] = m;
        weights[2] = i + 1;
    }
    /// The sum of the weights of any texel.
    static uint32_t total(uint32_t size) { return size % 2 ? size : 2; }
};

}  // namespace

uint32_t mipLevelCount(uint32_t width, uint32_t height) {
    uint32_t levels = 1;
    for (uint32_t size = std::max(width, height); size > 1; size /= 2) ++levels;
    return levels;
}

std::vector<uint8_t> halveImage(std::span<const uint8_t> pixels, uint32_t width, uint32_t height,
                                bool srgb) {
    const uint32_t halfWidth = std::max(width / 2, 1u), halfHeight = std::max(height / 2, 1u);
    std::vector<uint8_t> half(size_t(halfWidth) * halfHeight * 4);
    const SrgbTables& tables = srgbTables();
    const uint64_t total = uint64_t(Taps::total(width)) * Taps::total(height);
    uint8_t* out = half.data();
    for (uint32_t y = 0; y < halfHeight; ++y) {
        const Taps rows(y, height);
        for (uint32_t x = 0; x < halfWidth; ++x) {
            const Taps columns(x, width);
            for (size_t c = 0; c < 4; ++c) {
                const bool linear = srgb && c < 3;
                uint64_t sum = total / 2;
                for (uint32_t r = 0; r < rows.count; ++r) {
                    const uint8_t* texel = pixels.data() +
                                           (size_t(rows.first + r) * width + columns.first) * 4 + c;
                    uint64_t row = 0;
                    for (uint32_t k = 0; k < columns.count; ++k)
                        row += columns.weights[k] *
                               uint64_t(linear ? tables.toLinear[texel[k * 4]] : texel[k * 4]);
                    sum += row * rows.weights[r];
                }
                const size_t mean = size_t(sum / total);
                *out++ = linear ? tables.fromLinear[mean] : uint8_t(mean);
            }
        }
    }
    return half;
}

}  // namespace rushlight

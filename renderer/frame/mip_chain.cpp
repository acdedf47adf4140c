#include "renderer/frame/mip_chain.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kLinearSteps = 4096;

struct SrgbTables {
    std::array<uint16_t, 256> toLinear;               // 0 to kLinearSteps - 1
    std::array<uint8_t, kLinearSteps> fromLinear;

    SrgbTables() {
        for (uint32_t i = 0; i < 256; ++i) {
            const double s = i / 255.0;
            const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
            toLinear[i] = uint16_t(std::lround(linear * (kLinearSteps - 1)));
        }
        for (uint32_t i = 0; i < kLinearSteps; ++i) {
            const double x = double(i) / (kLinearSteps - 1);
            const double s =
                x <= 0.0031308 ? x * 12.92 : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
            fromLinear[i] = uint8_t(std::lround(s * 255));
        }
    }
};

const SrgbTables& srgbTables() {
    static const SrgbTables tables;
    return tables;
}

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
    for (uint32_t y = 0; y < halfHeight; ++y) {
        const uint8_t* row0 = pixels.data() + size_t(std::min(2 * y, height - 1)) * width * 4;
        const uint8_t* row1 = pixels.data() + size_t(std::min(2 * y + 1, height - 1)) * width * 4;
        uint8_t* out = half.data() + size_t(y) * halfWidth * 4;
        for (uint32_t x = 0; x < halfWidth; ++x, out += 4) {
            const size_t left = size_t(std::min(2 * x, width - 1)) * 4;
            const size_t right = size_t(std::min(2 * x + 1, width - 1)) * 4;
            for (size_t c = 0; c < 4; ++c) {
                const uint8_t a = row0[left + c], b = row0[right + c];
                const uint8_t d = row1[left + c], e = row1[right + c];
                if (srgb && c < 3) {
                    const auto& t = tables.toLinear;
                    out[c] = tables.fromLinear[size_t(t[a] + t[b] + t[d] + t[e] + 2) / 4];
                } else {
                    out[c] = uint8_t((a + b + d + e + 2) / 4);
                }
            }
        }
    }
    return half;
}

}  // namespace rushlight

#pragma once
// IEEE 754 binary16, as RGBA16F textures hold it.

#include <bit>
#include <cstdint>

namespace rushlight {

inline constexpr float kMaxHalf = 65504.0f;

/// Nearest half of a float (ties to even); over kMaxHalf, infinity included, gives kMaxHalf, NaN
/// gives 0.
inline uint16_t toHalf(float value) {
    const uint32_t bits = std::bit_cast<uint32_t>(value);
    const uint16_t sign = uint16_t(bits >> 16 & 0x8000u);
    uint32_t magnitude = bits & 0x7fffffffu;
    if (magnitude > 0x7f800000u) return 0;
    if (magnitude >= 0x477fe000u) return sign | 0x7bffu;
    if (magnitude < 0x38800000u) {
        // Subnormal: adding 0.5 puts the unit of the last place at 2^-24, where the hardware
        // rounds.
        const float shifted = std::bit_cast<float>(magnitude) + 0.5f;
        return sign | uint16_t(std::bit_cast<uint32_t>(shifted) - 0x3f000000u);
    }
    magnitude += 0x0fffu + (magnitude >> 13 & 1u);
    const uint32_t half = (magnitude - 0x38000000u) >> 13;
    return sign | uint16_t(half < 0x7bffu ? half : 0x7bffu);
}

inline float fromHalf(uint16_t half) {
    const uint32_t sign = uint32_t(half & 0x8000u) << 16;
    const uint32_t exponent = half >> 10 & 31u;
    const uint32_t mantissa = half & 0x3ffu;
    if (exponent == 0) {
        const float magnitude = float(mantissa) * 0x1p-24f;
        return sign ? -magnitude : magnitude;
    }
    const uint32_t wide = exponent == 31 ? 0x7f800000u : (exponent + 112u) << 23;
    return std::bit_cast<float>(sign | wide | mantissa << 13);
}

}  // namespace rushlight

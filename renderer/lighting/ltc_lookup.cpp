#include "renderer/lighting/ltc_table.h"

#include <algorithm>

namespace rushlight {

vec4 lookUpLtc(float nDotV, float roughness) {
    constexpr float kSize = float(RL_LTC_TABLE_SIZE);
    const vec2 at = interop::ltcCoordinates(nDotV, roughness) * kSize - 0.5f;
    const float x = std::clamp(at.x, 0.0f, kSize - 1), y = std::clamp(at.y, 0.0f, kSize - 1);
    const uint32_t x0 = uint32_t(x), y0 = uint32_t(y);
    const uint32_t x1 = std::min(x0 + 1, RL_LTC_TABLE_SIZE - 1u);
    const uint32_t y1 = std::min(y0 + 1, RL_LTC_TABLE_SIZE - 1u);
    const auto texel = [](uint32_t column, uint32_t row) {
        return kLtcTable[size_t(row) * RL_LTC_TABLE_SIZE + column];
    };
    const vec4 low = glm::mix(texel(x0, y0), texel(x1, y0), x - float(x0));
    const vec4 high = glm::mix(texel(x0, y1), texel(x1, y1), x - float(x0));
    return glm::mix(low, high, y - float(y0));
}

}  // namespace rushlight

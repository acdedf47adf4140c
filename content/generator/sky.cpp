#include "content/generator/sky.h"

#include "content/generator/noise.h"

#include <string_view>

namespace rushlight::content {
namespace {

constexpr int kWidth = 128, kHeight = 64;
/// Where the sun of square.cpp stands, without its height.
constexpr vec3 kSunside{-0.647f, 0, 0.762f};

vec3 skyRadiance(const vec3& d, float u, float v) {
    const vec3 zenith(0.085f, 0.125f, 0.25f), horizon(0.34f, 0.225f, 0.20f),
        glow(0.95f, 0.47f, 0.18f), ground(0.085f, 0.070f, 0.062f);
    const float up = d.y > 0 ? d.y : 0;
    const float low = (1 - up) * (1 - up);
    const float toSun = saturate(0.5f + 0.5f * dot(normalize(vec3(d.x, 0.001f, d.z)), kSunside));
    vec3 sky = mix(zenith, horizon, low * low);
    sky += glow * (toSun * toSun * toSun * low * low * low * 0.8f);
    const float veil = smooth(0.52f, 0.72f, fractalNoise(u, v, 6, 9, 4, 901)) * low;
    sky += vec3(0.16f, 0.085f, 0.06f) * (veil * (0.3f + 0.7f * toSun));
    // The far country fades into haze: a hard edge at the horizon would show over the roofs.
    return mix(sky, ground, smooth(0, 0.35f, -d.y));
}

/// Shared exponent: mantissas in [0, 256), the greatest at least 128 (Ward, "Real Pixels", Graphics
/// Gems II, 1991).
void putRgbe(std::vector<uint8_t>& out, const vec3& c) {
    float scale = 1;
    int exponent = 128 + 8;
    const float top = std::fmax(c.x, std::fmax(c.y, c.z));
    while (top * scale >= 256) scale *= 0.5f, ++exponent;
    while (top * scale < 128) scale *= 2, --exponent;
    for (int k = 0; k < 3; ++k) out.push_back(uint8_t(c[k] * scale));
    out.push_back(uint8_t(exponent));
}

}  // namespace

std::vector<uint8_t> encodeDuskSky() {
    constexpr std::string_view kHeader = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 128\n";
    std::vector<uint8_t> out(kHeader.begin(), kHeader.end());
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const float u = (float(x) + 0.5f) / kWidth, v = (float(y) + 0.5f) / kHeight;
            const double latitude = 0.5 * (0.5 - double(v)), longitude = double(u) - 0.5;
            const float around = float(cosTurns(latitude));
            putRgbe(out,
                    skyRadiance({around * float(cosTurns(longitude)), float(sinTurns(latitude)),
                                 around * float(sinTurns(longitude))},
                                u, v));
        }
    return out;
}

}  // namespace rushlight::content

#include "renderer/lighting/environment/equirect.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kRowsPerJob = 8;

}  // namespace

vec3 cleanRadiance(const vec3& pixel) {
    vec3 result;
    for (int c = 0; c < 3; ++c) result[c] = std::isfinite(pixel[c]) && pixel[c] > 0 ? pixel[c] : 0;
    return result;
}

float equirectTexelSolidAngle(uint32_t y, uint32_t width, uint32_t height) {
    const double top = kPi * double(y) / height, bottom = kPi * double(y + 1) / height;
    return float(2.0 * kPi / width * (std::cos(top) - std::cos(bottom)));
}

vec3 equirectDirection(float u, float v) {
    const float phi = (u - 0.5f) * 2.0f * kPi;
    const float latitude = (0.5f - v) * kPi;
    const float ring = std::cos(latitude);
    return {ring * std::cos(phi), std::sin(latitude), ring * std::sin(phi)};
}

vec4 Equirect::sample(const vec3& d) const {
    const float u = std::atan2(d.z, d.x) * (0.5f / kPi) + 0.5f;
    const float v = 0.5f - std::asin(std::clamp(d.y, -1.0f, 1.0f)) * (1.0f / kPi);
    const float x = u * float(width) + float(width) - 0.5f;  // one turn on: never negative
    const float y = std::clamp(v * float(height) - 0.5f, 0.0f, float(height - 1));
    const uint32_t wide = uint32_t(x);
    const uint32_t x0 = wide % width, x1 = (wide + 1) % width;
    const uint32_t y0 = uint32_t(y), y1 = std::min(y0 + 1, height - 1);
    const float fx = x - float(wide), fy = y - float(y0);
    const vec4* low = &texels[size_t(y0) * width];
    const vec4* high = &texels[size_t(y1) * width];
    const vec4 a = low[x0] + (low[x1] - low[x0]) * fx;
    const vec4 b = high[x0] + (high[x1] - high[x0]) * fx;
    return a + (b - a) * fy;
}

Equirect makeEquirect(const EnvironmentDesc& desc, uint32_t maxWidth, JobSystem& jobs) {
    const uint32_t factor = (desc.width + maxWidth - 1) / maxWidth;
    Equirect result;
    result.width = (desc.width + factor - 1) / factor;
    result.height = (desc.height + factor - 1) / factor;
    result.texels.resize(size_t(result.width) * result.height);
    jobs.forRanges(result.height, kRowsPerJob, [&](uint32_t begin, uint32_t end) {
        for (uint32_t y = begin; y < end; ++y) {
            for (uint32_t x = 0; x < result.width; ++x) {
                vec3 sum(0);
                float total = 0;
                for (uint32_t sy = y * factor; sy < std::min((y + 1) * factor, desc.height); ++sy) {
                    const float weight = factor == 1
                                             ? 1
                                             : equirectTexelSolidAngle(sy, desc.width, desc.height);
                    for (uint32_t sx = x * factor; sx < std::min((x + 1) * factor, desc.width);
                         ++sx) {
                        sum += cleanRadiance(desc.pixels[size_t(sy) * desc.width + sx]) * weight;
                        total += weight;
                    }
                }
                result.texels[size_t(y) * result.width + x] = vec4(sum / total, 1);
            }
        }
    });
    return result;
}

CubeLevel projectToCube(const Equirect& source, uint32_t size, JobSystem& jobs) {
    CubeLevel result(size);
    jobs.forRanges(6 * size, kRowsPerJob, [&](uint32_t begin, uint32_t end) {
        const float scale = 2.0f / float(size);
        for (uint32_t row = begin; row < end; ++row) {
            const uint32_t face = row / size, y = row % size;
            for (uint32_t x = 0; x < size; ++x)
                result.at(face, x, y) = source.sample(glm::normalize(cubeDirection(
                    face, (float(x) + 0.5f) * scale - 1, (float(y) + 0.5f) * scale - 1)));
        }
    });
    result.fillBorders();
    return result;
}

}  // namespace rushlight

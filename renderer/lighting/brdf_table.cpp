#include "renderer/lighting/brdf_table.h"

#include "interop/brdf.h"
#include "renderer/geometry/half.h"
#include "renderer/lighting/environment/sampling.h"

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

constexpr uint32_t kSamples = 128;

}  // namespace

// Sampling visible normals leaves the weight F * G2 / G1 = F * 2 nDotL (nDotV + rootV) / (2 (...))
// in [0, 1].
vec2 integrateBrdf(float nDotV, float roughness, uint32_t samples) {
    const float r = interop::clampRoughness(roughness);
    const float alpha = r * r;
    const float alpha2 = alpha * alpha;
    const float cosine = std::clamp(nDotV, interop::kMinNdotV, 1.0f);
    const vec3 view(std::sqrt(1.0f - cosine * cosine), 0, cosine);
    const float rootV = interop::smithRoot(cosine, alpha2);
    float scale = 0, bias = 0;
    for (uint32_t i = 0; i < samples; ++i) {
        const vec3 half = sampleVisibleNormal(view, alpha, hammersley(i, samples));
        const float vDotH = std::max(glm::dot(view, half), 0.0f);
        const float nDotL = 2.0f * vDotH * half.z - cosine;
        if (nDotL <= 0) continue;
        const float rootL = interop::smithRoot(nDotL, alpha2);
        // G1 = 2 nDotV / (nDotV + rootV); G2 = 4 nDotL nDotV V
        const float weight = 2.0f * nDotL * (cosine + rootV) *
                             interop::visibilitySmith(cosine, nDotL, rootV, rootL);
        const float fresnel = interop::pow5(1.0f - std::min(vDotH, 1.0f));
        scale += weight * (1.0f - fresnel);
        bias += weight * fresnel;
    }
    return vec2(scale, bias) / float(samples);
}

BrdfTable makeBrdfTable(JobSystem& jobs, uint32_t size) {
    BrdfTable table;
    table.size = size;
    table.texels.resize(size_t(size) * size);
    jobs.forRanges(size, 4, [&](uint32_t begin, uint32_t end) {
        for (uint32_t y = begin; y < end; ++y)
            for (uint32_t x = 0; x < size; ++x)
                table.texels[size_t(y) * size + x] = integrateBrdf(
                    float(x) / float(size - 1), float(y) / float(size - 1), kSamples);
    });
    return table;
}

vec2 BrdfTable::lookUp(float nDotV, float roughness) const {
    const float limit = float(size) - 1;
    const float x = std::clamp(nDotV * limit, 0.0f, limit);
    const float y = std::clamp(roughness * limit, 0.0f, limit);
    const uint32_t x0 = uint32_t(x), y0 = uint32_t(y);
    const uint32_t x1 = std::min(x0 + 1, size - 1), y1 = std::min(y0 + 1, size - 1);
    const auto at = [&](uint32_t column, uint32_t row) {
        return texels[size_t(row) * size + column];
    };
    const vec2 low = glm::mix(at(x0, y0), at(x1, y0), x - float(x0));
    const vec2 high = glm::mix(at(x0, y1), at(x1, y1), x - float(x0));
    return glm::mix(low, high, y - float(y0));
}

std::vector<uint16_t> BrdfTable::halves() const {
    std::vector<uint16_t> result;
    result.reserve(texels.size() * 2);
    for (const vec2& t : texels) {
        result.push_back(toHalf(t.x));
        result.push_back(toHalf(t.y));
    }
    return result;
}

}  // namespace rushlight

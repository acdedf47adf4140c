#include "renderer/lighting/environment/environment.h"

#include "engine/core/hash.h"
#include "interop/brdf.h"
#include "renderer/geometry/half.h"
#include "renderer/geometry/vertex_packing.h"
#include "renderer/lighting/environment/cube_image.h"
#include "renderer/lighting/environment/equirect.h"
#include "renderer/lighting/environment/sampling.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

namespace rushlight {
namespace {

constexpr uint32_t kMaxSide = 16384;
constexpr uint32_t kHashVersion = 2;  // counted up whenever the same input gives another result
/// By level; wider lobes read coarser sources, and there are fewer texels to fill.
constexpr std::array<uint32_t, kEnvironmentLevels> kSamples = {1, 40, 80, 192, 384, 768};

/// One direction of a level's lobe around +z: all texels share them, since view = normal =
/// reflection.
struct LobeSample {
    vec3 light;
    float weight;
    uint32_t level;
};

// Krivanek and Colbert 2008, "Real-time Shading with Filtered Importance Sampling": a sample reads
// the source level whose texel covers its share of the sphere, 1 / (count * pdf), and two levels
// more so that shares overlap. That is also what keeps a small bright sun from sparkling, without
// losing any of its energy. With view = normal, pdf(light) = D(h) n.h / (4 v.h) = D(h) / 4.
std::vector<LobeSample> makeLobe(float roughness, uint32_t count, uint32_t sourceSize,
                                 uint32_t sourceLevels) {
    const float alpha = roughness * roughness;
    const float alpha2 = alpha * alpha;
    const float texelAngle = 4.0f * kPi / (6.0f * float(sourceSize) * float(sourceSize));
    std::vector<LobeSample> lobe;
    float total = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const vec3 half = sampleGgxNormal(alpha2, hammersley(i, count));
        const vec3 light = 2.0f * half.z * half - vec3(0, 0, 1);
        if (light.z <= 0) continue;
        const float pdf = interop::distributionGgx(half.z, alpha2) * 0.25f;
        const float shares = 1.0f / (float(count) * pdf * texelAngle);
        const float level = std::max(0.5f * std::log2(shares) + 2.0f, 0.0f);
        lobe.push_back({light, light.z, std::min(uint32_t(level + 0.5f), sourceLevels - 1)});
        total += light.z;
    }
    for (LobeSample& s : lobe) s.weight /= total;
    return lobe;
}

void storeTexel(uint16_t* out, const vec4& radiance) {
    for (int c = 0; c < 3; ++c) out[c] = toHalf(radiance[c]);
    out[3] = 0x3c00;  // 1
}

void storeLevel(const CubeLevel& level, uint16_t* out) {
    const uint32_t size = level.size();
    for (uint32_t face = 0; face < 6; ++face)
        for (uint32_t y = 0; y < size; ++y)
            for (uint32_t x = 0; x < size; ++x, out += 4) storeTexel(out, level.at(face, x, y));
}

void filterLevel(std::span<const CubeLevel> chain, std::span<const LobeSample> lobe, uint32_t size,
                 uint16_t* out, JobSystem& jobs) {
    jobs.forRanges(6 * size, std::max(size / 16, 1u), [&](uint32_t begin, uint32_t end) {
        for (uint32_t row = begin; row < end; ++row) {
            const uint32_t face = row / size, y = row % size;
            for (uint32_t x = 0; x < size; ++x) {
                const float scale = 2.0f / float(size);
                const vec3 normal = glm::normalize(cubeDirection(
                    face, (float(x) + 0.5f) * scale - 1, (float(y) + 0.5f) * scale - 1));
                const vec3 tangent = perpendicular(normal);
                const vec3 bitangent = glm::cross(normal, tangent);
                vec4 sum(0);
                for (const LobeSample& s : lobe)
                    sum += chain[s.level].sample(tangent * s.light.x + bitangent * s.light.y +
                                                 normal * s.light.z) *
                           s.weight;
                storeTexel(out + (size_t(row) * size + x) * 4, sum);
            }
        }
    });
}

/// What a texel of the source sends, as a whole.
struct Patch {
    vec3 direction;
    float solidAngle;
    vec4 radiance;
};

std::vector<Patch> listPatches(const CubeLevel& level) {
    const uint32_t size = level.size();
    const float scale = 2.0f / float(size);
    std::vector<Patch> patches;
    patches.reserve(size_t(6) * size * size);
    for (uint32_t face = 0; face < 6; ++face)
        for (uint32_t y = 0; y < size; ++y)
            for (uint32_t x = 0; x < size; ++x)
                patches.push_back({glm::normalize(cubeDirection(face, (float(x) + 0.5f) * scale - 1,
                                                                (float(y) + 0.5f) * scale - 1)),
                                   cubeTexelSolidAngle(x, y, size), level.at(face, x, y)});
    return patches;
}

// The whole sum: a cosine lobe is so wide that a small source is as good as a large one.
void filterIrradiance(const CubeLevel& source, uint16_t* out, JobSystem& jobs) {
    const std::vector<Patch> patches = listPatches(source);
    constexpr uint32_t size = kIrradianceSize;
    constexpr float scale = 2.0f / float(size);
    jobs.forRanges(6 * size, 4, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin * size; i < end * size; ++i) {
            const uint32_t x = i % size, y = i / size % size, face = i / (size * size);
            const vec3 normal = glm::normalize(
                cubeDirection(face, (float(x) + 0.5f) * scale - 1, (float(y) + 0.5f) * scale - 1));
            vec4 sum(0);
            float total = 0;
            for (const Patch& patch : patches) {
                const float weight = std::max(glm::dot(normal, patch.direction), 0.0f) *
                                     patch.solidAngle;
                sum += patch.radiance * weight;
                total += weight;
            }
            storeTexel(out + size_t(i) * 4, sum / total);
        }
    });
}

std::vector<CubeLevel> makeChain(CubeLevel source, JobSystem& jobs) {
    std::vector<CubeLevel> chain;
    chain.push_back(std::move(source));
    while (chain.back().size() > 1) chain.push_back(halveCube(chain.back(), jobs));
    return chain;
}

Result<void> checkDesc(const EnvironmentDesc& desc) {
    const std::string name(desc.label);
    if (!desc.width || !desc.height || desc.width > kMaxSide || desc.height > kMaxSide)
        return fail(name, "The environment is " + std::to_string(desc.width) + " x " +
                              std::to_string(desc.height) + " pixels; each side must be 1 to " +
                              std::to_string(kMaxSide) + ".");
    if (desc.pixels.size() != size_t(desc.width) * desc.height)
        return fail(name, "The environment has " + std::to_string(desc.pixels.size()) +
                              " pixels where its size of " + std::to_string(desc.width) + " x " +
                              std::to_string(desc.height) + " needs " +
                              std::to_string(size_t(desc.width) * desc.height) + ".");
    return {};
}

}  // namespace

size_t CubeTexels::halfCount(uint32_t size, uint32_t levels) {
    size_t count = 0;
    for (uint32_t level = 0; level < levels; ++level)
        count += size_t(6) * 4 * (size >> level) * (size >> level);
    return count;
}

std::span<const uint16_t> CubeTexels::face(uint32_t level, uint32_t index) const {
    const size_t faceHalves = size_t(4) * levelSize(level) * levelSize(level);
    return std::span(halves).subspan(halfCount(size, level) + index * faceHalves, faceHalves);
}

uint64_t environmentHash(const EnvironmentDesc& desc) {
    const uint32_t key[] = {kHashVersion,     desc.width,         desc.height,
                            kEnvironmentSize, kEnvironmentLevels, kMaxBackgroundSize,
                            kIrradianceSize};
    return hashBytes(desc.pixels.data(), desc.pixels.size_bytes(), hashBytes(key, sizeof key));
}

Result<PrefilteredEnvironment> prefilterEnvironment(const EnvironmentDesc& desc, JobSystem& jobs) {
    if (auto checked = checkDesc(desc); !checked) return tl::unexpected(checked.error());
    const Equirect source = makeEquirect(desc, 4 * kMaxBackgroundSize, jobs);

    // A face of width / 4 texels has the source's resolution; twice that keeps it sharp under
    // bilinear filtering.
    const uint32_t wanted = std::bit_ceil(std::max(source.width / 4, 1u)) * 2;
    const uint32_t backgroundSize = std::clamp(wanted, kEnvironmentSize, kMaxBackgroundSize);
    return prefilterCube(projectToCube(source, backgroundSize, jobs), jobs);
}

PrefilteredEnvironment prefilterCube(CubeLevel source, JobSystem& jobs) {
    const uint32_t size = source.size();
    RL_CHECK(std::has_single_bit(size), "a cube's size is a power of two");
    const std::vector<CubeLevel> chain = makeChain(
        size < kEnvironmentSize ? resizeCube(source, kEnvironmentSize, jobs) : std::move(source),
        jobs);
    const uint32_t sourceSize = chain[0].size();
    const uint32_t backgroundSize = std::min(sourceSize, kMaxBackgroundSize);
    const auto levelOf = [&](uint32_t wanted) -> const CubeLevel& {
        return chain[size_t(std::countr_zero(sourceSize / wanted))];
    };

    PrefilteredEnvironment result;
    result.irradiance = {kIrradianceSize, 1, {}};
    result.irradiance.halves.resize(CubeTexels::halfCount(kIrradianceSize, 1));
    filterIrradiance(levelOf(2 * kIrradianceSize), result.irradiance.halves.data(), jobs);
    result.background = {backgroundSize, 1, {}};
    result.background.halves.resize(CubeTexels::halfCount(backgroundSize, 1));
    storeLevel(levelOf(backgroundSize), result.background.halves.data());

    CubeTexels& specular = result.specular;
    specular = {kEnvironmentSize, kEnvironmentLevels, {}};
    specular.halves.resize(CubeTexels::halfCount(kEnvironmentSize, kEnvironmentLevels));
    storeLevel(levelOf(kEnvironmentSize), specular.halves.data());
    for (uint32_t level = 1; level < kEnvironmentLevels; ++level) {
        const float roughness = float(level) / float(kEnvironmentLevels - 1);
        const auto lobe = makeLobe(roughness, kSamples[level], sourceSize, uint32_t(chain.size()));
        filterLevel(chain, lobe, specular.levelSize(level),
                    specular.halves.data() + CubeTexels::halfCount(kEnvironmentSize, level), jobs);
    }
    return result;
}

}  // namespace rushlight

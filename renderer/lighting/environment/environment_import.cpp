// Environments that were prefiltered elsewhere, in the renderer's own sizes and levels of
// roughness.
#include "renderer/lighting/environment/environment.h"

#include "renderer/geometry/half.h"
#include "renderer/lighting/environment/equirect.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

namespace rushlight {
namespace {

constexpr uint32_t kMaxSide = 4096;

size_t texelCount(uint32_t size, uint32_t levels) {
    return CubeTexels::halfCount(size, levels) / 4;
}

Result<void> check(const PrefilteredEnvironmentDesc& desc) {
    const std::string name(desc.label);
    if (desc.size == 0 || desc.size > kMaxSide || !std::has_single_bit(desc.size))
        return fail(name, "The prefiltered environment has faces of " + std::to_string(desc.size) +
                              " texels; it must be a power of two from 1 to 4,096.");
    if (desc.levels == 0 || desc.levels > uint32_t(std::bit_width(desc.size)))
        return fail(name, "The prefiltered environment has " + std::to_string(desc.levels) +
                              " levels; faces of " + std::to_string(desc.size) +
                              " texels have 1 to " + std::to_string(std::bit_width(desc.size)) +
                              ".");
    if (desc.texels.size() != texelCount(desc.size, desc.levels))
        return fail(name, "The prefiltered environment has " + std::to_string(desc.texels.size()) +
                              " texels where its faces and levels need " +
                              std::to_string(texelCount(desc.size, desc.levels)) + ".");
    for (const vec3& c : desc.irradiance)
        if (!std::isfinite(c.x + c.y + c.z))
            return fail(name, "A coefficient of the environment's irradiance is not finite.");
    if (!(std::abs(glm::length(desc.rotation) - 1) < 1e-2f))
        return fail(name, "The rotation of the environment is no unit quaternion.");
    return {};
}

CubeLevel readLevel(const PrefilteredEnvironmentDesc& desc, uint32_t level) {
    const uint32_t size = desc.size >> level;
    const vec3* from = desc.texels.data() + texelCount(desc.size, level);
    CubeLevel cube(size);
    for (uint32_t face = 0; face < 6; ++face)
        for (uint32_t y = 0; y < size; ++y)
            for (uint32_t x = 0; x < size; ++x)
                cube.at(face, x, y) = vec4(cleanRadiance(*from++), 1);
    cube.fillBorders();
    return cube;
}

/// `radiance(direction)` for all texels of one level; directions are unit and in the environment's
/// own space.
template <class F>
void fill(uint32_t size, const quat& rotation, JobSystem& jobs, uint16_t* out, F&& radiance) {
    const quat toSource = glm::conjugate(glm::normalize(rotation));
    jobs.forRanges(6 * size, std::max(size / 16, 1u), [&](uint32_t begin, uint32_t end) {
        for (uint32_t row = begin; row < end; ++row)
            for (uint32_t x = 0; x < size; ++x) {
                const float scale = 2.0f / float(size);
                const vec3 d = cubeDirection(row / size, (float(x) + 0.5f) * scale - 1,
                                             (float(row % size) + 0.5f) * scale - 1);
                const vec3 c = radiance(toSource * glm::normalize(d));
                uint16_t* texel = out + (size_t(row) * size + x) * 4;
                for (int i = 0; i < 3; ++i) texel[i] = toHalf(c[i]);
                texel[3] = 0x3c00;  // 1
            }
    });
}

/// No finer than what is sampled from it.
CubeLevel coarsened(CubeLevel level, uint32_t size, JobSystem& jobs) {
    while (level.size() > size) level = halveCube(level, jobs);
    return level;
}

// Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps",
// equation 3.
vec3 irradianceOverPi(const std::array<vec3, 9>& c, const vec3& n) {
    const vec3 irradiance = c[0] * 0.282095f + (c[1] * n.y + c[2] * n.z + c[3] * n.x) * 0.488603f +
                            (c[4] * (n.x * n.y) + c[5] * (n.y * n.z) + c[7] * (n.x * n.z)) *
                                1.092548f +
                            c[6] * (0.315392f * (3 * n.z * n.z - 1)) +
                            c[8] * (0.546274f * (n.x * n.x - n.y * n.y));
    return glm::max(irradiance / kPi, vec3(0));
}

CubeTexels emptyCube(uint32_t size, uint32_t levels) {
    CubeTexels cube{size, levels, {}};
    cube.halves.resize(CubeTexels::halfCount(size, levels));
    return cube;
}

}  // namespace

// Both have levels of evenly spaced roughness, but not as many: what lies between two of the given
// ones is mixed of them.
Result<PrefilteredEnvironment> convertPrefiltered(const PrefilteredEnvironmentDesc& desc,
                                                  JobSystem& jobs) {
    if (auto ok = check(desc); !ok) return tl::unexpected(ok.error());
    std::vector<CubeLevel> given;
    for (uint32_t level = 0; level < desc.levels; ++level) given.push_back(readLevel(desc, level));

    PrefilteredEnvironment result;
    const uint32_t backgroundSize = std::clamp(desc.size, kEnvironmentSize, kMaxBackgroundSize);
    result.background = emptyCube(backgroundSize, 1);
    const CubeLevel sharp = coarsened(given[0], backgroundSize, jobs);
    fill(backgroundSize, desc.rotation, jobs, result.background.halves.data(),
         [&](const vec3& d) { return vec3(sharp.sample(d)); });
    result.irradiance = emptyCube(kIrradianceSize, 1);
    fill(kIrradianceSize, desc.rotation, jobs, result.irradiance.halves.data(),
         [&](const vec3& d) { return irradianceOverPi(desc.irradiance, d); });
    result.specular = emptyCube(kEnvironmentSize, kEnvironmentLevels);
    if (desc.levels == 1) {  // nothing is blurred yet
        CubeLevel turned(kEnvironmentSize);
        const quat toSource = glm::conjugate(glm::normalize(desc.rotation));
        for (uint32_t i = 0; i < 6 * kEnvironmentSize * kEnvironmentSize; ++i) {
            const uint32_t x = i % kEnvironmentSize, y = i / kEnvironmentSize % kEnvironmentSize;
            const uint32_t face = i / (kEnvironmentSize * kEnvironmentSize);
            const float scale = 2.0f / float(kEnvironmentSize);
            turned.at(face, x, y) = sharp.sample(
                toSource *
                cubeDirection(face, (float(x) + 0.5f) * scale - 1, (float(y) + 0.5f) * scale - 1));
        }
        turned.fillBorders();
        result.specular = prefilterCube(std::move(turned), jobs).specular;
        return result;
    }
    for (uint32_t level = 0; level < kEnvironmentLevels; ++level) {
        const float roughness = float(level) / float(kEnvironmentLevels - 1);
        const float at = roughness * float(desc.levels - 1);
        const uint32_t low = std::min(uint32_t(at), desc.levels - 2);
        const float share = at - float(low);
        const uint32_t size = kEnvironmentSize >> level;
        const CubeLevel sharper = coarsened(given[low], size, jobs);
        const CubeLevel rougher = coarsened(given[low + 1], size, jobs);
        fill(size, desc.rotation, jobs,
             result.specular.halves.data() + CubeTexels::halfCount(kEnvironmentSize, level),
             [&](const vec3& d) {
                 return vec3(glm::mix(sharper.sample(d), rougher.sample(d), share));
             });
    }
    return result;
}

}  // namespace rushlight

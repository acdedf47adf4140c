#include "renderer/resources/environment_store.h"

#include "renderer/lighting/brdf_table.h"
#include "renderer/lighting/environment/environment_cache.h"
#include "renderer/lighting/ltc_table.h"

#include "renderer/geometry/half.h"
#include "renderer/lighting/environment/cube_image.h"

namespace rushlight {
namespace {

// Over the sphere, irradiance over pi has the mean of the radiance, and two thirds of its mean
// times direction (Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance
// Environment Maps").
std::array<vec4, 3> bandsOf(const CubeTexels& irradiance) {
    std::array<vec4, 3> bands{};
    for (uint32_t face = 0; face < 6; ++face)
        for (uint32_t y = 0; y < irradiance.size; ++y)
            for (uint32_t x = 0; x < irradiance.size; ++x) {
                const float scale = 2.0f / float(irradiance.size);
                const vec3 d = glm::normalize(cubeDirection(face, (float(x) + 0.5f) * scale - 1,
                                                            (float(y) + 0.5f) * scale - 1));
                const float share = cubeTexelSolidAngle(x, y, irradiance.size) / (4 * kPi);
                const uint16_t* texel = &irradiance.face(
                    0, face)[(size_t(y) * irradiance.size + x) * 4];
                for (size_t c = 0; c < 3; ++c)
                    bands[c] += vec4(1, 1.5f * d) * (fromHalf(texel[c]) * share);
            }
    return bands;
}

}  // namespace

EnvironmentStore::EnvironmentStore(Device& device, JobSystem& jobs, LogSink log,
                                   std::string cacheDirectory)
    : device_(device), jobs_(jobs), log_(log), cacheDirectory_(std::move(cacheDirectory)) {}

EnvironmentStore::~EnvironmentStore() {
    environments_.forEach(
        [&](EnvironmentHandle, GpuEnvironment& environment) { destroyTextures(environment); });
    if (brdfTable_) device_.destroy(brdfTable_);
    if (ltcTable_) device_.destroy(ltcTable_);
}

Result<EnvironmentHandle> EnvironmentStore::create(const EnvironmentDesc& desc) {
    auto prefiltered = prefilterEnvironmentCached(desc, cacheDirectory_, jobs_, log_);
    if (!prefiltered) return tl::unexpected(prefiltered.error());
    return create(*prefiltered);
}

Result<EnvironmentHandle> EnvironmentStore::create(const PrefilteredEnvironment& prefiltered) {
    const auto environment = upload(prefiltered);
    if (!environment) return tl::unexpected(environment.error());
    return environments_.insert(*environment);
}

Result<void> EnvironmentStore::update(EnvironmentHandle handle,
                                      const PrefilteredEnvironment& prefiltered) {
    GpuEnvironment* environment = environments_.find(handle);
    if (!environment)
        return fail("environment", "the handle is stale or none.", ErrorKind::wrongUse);
    const auto made = upload(prefiltered);
    if (!made) return tl::unexpected(made.error());
    destroyTextures(*environment);
    *environment = *made;
    return {};
}

Result<GpuEnvironment> EnvironmentStore::upload(const PrefilteredEnvironment& prefiltered) {
    GpuEnvironment environment;
    environment.content = ++contents_;
    const auto upload = [&](const char* label, const CubeTexels& cube, TextureHandle& texture) {
        auto uploaded = uploadCube(label, cube);
        if (uploaded) texture = *uploaded;
        return uploaded;
    };
    auto step = upload("environment-irradiance", prefiltered.irradiance, environment.irradiance);
    if (step) step = upload("environment-specular", prefiltered.specular, environment.specular);
    if (step)
        step = upload("environment-background", prefiltered.background, environment.background);
    environment.bands = bandsOf(prefiltered.irradiance);
    if (step) return environment;
    destroyTextures(environment);
    return tl::unexpected(step.error());
}

void EnvironmentStore::destroyTextures(const GpuEnvironment& environment) {
    for (TextureHandle texture :
         {environment.irradiance, environment.specular, environment.background})
        if (texture) device_.destroy(texture);
}

void EnvironmentStore::destroy(EnvironmentHandle handle) {
    const GpuEnvironment* environment = environments_.find(handle);
    if (!environment) return;
    destroyTextures(*environment);
    environments_.erase(handle);
}

Result<TextureHandle> EnvironmentStore::uploadCube(const char* label, const CubeTexels& cube) {
    TextureDesc desc;
    desc.label = label;
    desc.kind = TextureKind::cube;
    desc.format = Format::rgba16f;
    desc.width = desc.height = cube.size;
    desc.layers = 6;
    desc.mipLevels = cube.levels;
    auto texture = device_.createTexture(desc);
    if (!texture) return texture;
    for (uint32_t level = 0; level < cube.levels; ++level)
        for (uint32_t face = 0; face < 6; ++face)
            device_.write(*texture, {level, face, 1, cube.levelSize(level), cube.levelSize(level)},
                          std::as_bytes(cube.face(level, face)));
    return texture;
}

Result<TextureHandle> EnvironmentStore::brdfTable() {
    if (brdfTable_) return brdfTable_;
    const BrdfTable table = makeBrdfTable(jobs_);
    TextureDesc desc;
    desc.label = "brdf-table";
    desc.format = Format::rg16f;
    desc.width = desc.height = table.size;
    auto texture = device_.createTexture(desc);
    if (!texture) return texture;
    const std::vector<uint16_t> halves = table.halves();
    device_.write(*texture, {0, 0, 1, table.size, table.size}, std::as_bytes(std::span(halves)));
    return brdfTable_ = *texture;
}

Result<TextureHandle> EnvironmentStore::ltcTable() {
    if (ltcTable_) return ltcTable_;
    TextureDesc desc;
    desc.label = "ltc-table";
    desc.format = Format::rgba32f;
    desc.width = desc.height = RL_LTC_TABLE_SIZE;
    auto texture = device_.createTexture(desc);
    if (!texture) return texture;
    device_.write(*texture, {0, 0, 1, desc.width, desc.height},
                  std::as_bytes(std::span(kLtcTable)));
    return ltcTable_ = *texture;
}

}  // namespace rushlight

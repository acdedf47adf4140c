#include "renderer/frame/environment_store.h"

#include "renderer/frame/brdf_table.h"
#include "renderer/frame/ltc_table.h"
#include "renderer/frame/environment_cache.h"

namespace rushlight {

EnvironmentStore::EnvironmentStore(Device& device, JobSystem& jobs, LogSink log,
                                   std::string cacheDirectory)
    : device_(device), jobs_(jobs), log_(log), cacheDirectory_(std::move(cacheDirectory)) {}

EnvironmentStore::~EnvironmentStore() {
    environments_.forEach([&](EnvironmentHandle, GpuEnvironment& environment) {
        destroyTextures(environment);
    });
    if (brdfTable_) device_.destroy(brdfTable_);
    if (ltcTable_) device_.destroy(ltcTable_);
}

Result<EnvironmentHandle> EnvironmentStore::create(const EnvironmentDesc& desc) {
    auto prefiltered = prefilterEnvironmentCached(desc, cacheDirectory_, jobs_, log_);
    if (!prefiltered) return tl::unexpected(prefiltered.error());
    GpuEnvironment environment;
    const auto upload = [&](const char* label, const CubeTexels& cube, TextureHandle& texture) {
        auto uploaded = uploadCube(label, cube);
        if (uploaded) texture = *uploaded;
        return uploaded;
    };
    auto step = upload("environment-irradiance", prefiltered->irradiance, environment.irradiance);
    if (step) step = upload("environment-specular", prefiltered->specular, environment.specular);
    if (step)
        step = upload("environment-background", prefiltered->background, environment.background);
    if (step) return environments_.insert(environment);
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
            device_.write(*texture,
                          {level, face, 1, cube.levelSize(level), cube.levelSize(level)},
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

#pragma once

#include "engine/core/log.h"
#include "renderer/lighting/environment/environment.h"
#include "renderer/rhi/device.h"

#include <array>
#include <string>

namespace rushlight {

/// An environment as lighting reads it.
struct GpuEnvironment {
    TextureHandle irradiance;  ///< cube of irradiance over pi, RGBA16F
    TextureHandle specular;    ///< prefiltered cube, RGBA16F
    TextureHandle background;  ///< sharp cube, RGBA16F
    /// In two bands, by colour: x: mean radiance, yzw: mean of radiance times direction.
    std::array<vec4, 3> bands{};
    uint64_t content = 0;  ///< another number for all that is made or made anew; never 0
};

/// Prefilters environments (or takes them from the cache on disk) and holds their cubes and the
/// BRDF table.
class EnvironmentStore {
public:
    EnvironmentStore(Device& device, JobSystem& jobs, LogSink log, std::string cacheDirectory);
    ~EnvironmentStore();
    EnvironmentStore(const EnvironmentStore&) = delete;
    EnvironmentStore& operator=(const EnvironmentStore&) = delete;

    Result<EnvironmentHandle> create(const EnvironmentDesc&);
    Result<EnvironmentHandle> create(const PrefilteredEnvironment&);
    /// Other light under the same handle. After an Error the old one stays.
    Result<void> update(EnvironmentHandle, const PrefilteredEnvironment&);
    void destroy(EnvironmentHandle);
    const GpuEnvironment* find(EnvironmentHandle environment) const {
        return environments_.find(environment);
    }
    /// RG16F; made when first asked for.
    Result<TextureHandle> brdfTable();
    /// RGBA32F, the matrices of interop::applyLtc; made when first asked for.
    Result<TextureHandle> ltcTable();

private:
    Result<TextureHandle> uploadCube(const char* label, const CubeTexels&);
    Result<GpuEnvironment> upload(const PrefilteredEnvironment&);
    void destroyTextures(const GpuEnvironment&);

    Device& device_;
    JobSystem& jobs_;
    LogSink log_;
    std::string cacheDirectory_;
    Pool<GpuEnvironment, EnvironmentTag> environments_;
    uint64_t contents_ = 0;
    TextureHandle brdfTable_;
    TextureHandle ltcTable_;
};

}  // namespace rushlight

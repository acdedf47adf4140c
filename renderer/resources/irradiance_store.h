#pragma once

#include "renderer/frame/frame_input.h"
#include "renderer/lighting/irradiance_volume.h"
#include "renderer/rhi/device.h"

namespace rushlight {

/// An irradiance volume as the shaders read it.
struct GpuIrradianceVolume {
    ProbeGrid grid;
    BufferHandle records;
    uint64_t recordBytes = 0;
    TextureHandle distances;

    BufferRange recordRange() const { return {records, 0, 0, recordBytes}; }
};

class IrradianceStore {
public:
    explicit IrradianceStore(Device& device) : device_(device) {}
    ~IrradianceStore();
    IrradianceStore(const IrradianceStore&) = delete;
    IrradianceStore& operator=(const IrradianceStore&) = delete;

    Result<IrradianceVolumeHandle> create(const IrradianceVolume&);
    /// New light for the same grid; the distances are taken to be what they were.
    Result<void> update(IrradianceVolumeHandle, const IrradianceVolume&);
    void destroy(IrradianceVolumeHandle);
    const GpuIrradianceVolume* find(IrradianceVolumeHandle volume) const {
        return volumes_.find(volume);
    }

private:
    void release(const GpuIrradianceVolume&);

    Device& device_;
    Pool<GpuIrradianceVolume, IrradianceVolumeTag> volumes_;
};

}  // namespace rushlight

#include "renderer/resources/irradiance_store.h"

namespace rushlight {

IrradianceStore::~IrradianceStore() {
    volumes_.forEach([&](IrradianceVolumeHandle, GpuIrradianceVolume& v) { release(v); });
}

void IrradianceStore::release(const GpuIrradianceVolume& v) {
    if (v.records) device_.destroy(v.records);
    if (v.distances) device_.destroy(v.distances);
}

Result<IrradianceVolumeHandle> IrradianceStore::create(const IrradianceVolume& volume) {
    if (auto ok = checkIrradianceVolume(volume, "irradiance volume"); !ok)
        return tl::unexpected(ok.error());
    GpuIrradianceVolume v;
    v.grid = volume.grid;
    v.recordBytes = volume.records.size() * sizeof(uvec4);
    const auto buffer = device_.createBuffer({"probe-records", v.recordBytes, BufferUsage::texel});
    if (!buffer) return tl::unexpected(buffer.error());
    v.records = *buffer;
    const ProbeAtlas atlas = makeProbeAtlas(volume);
    TextureDesc desc;
    desc.label = "probe-distances";
    desc.format = Format::rg16f;
    desc.width = atlas.width;
    desc.height = atlas.height;
    const auto texture = device_.createTexture(desc);
    if (!texture) {
        release(v);
        return tl::unexpected(texture.error());
    }
    v.distances = *texture;
    device_.write(v.records, 0, std::as_bytes(std::span(volume.records)));
    device_.write(v.distances, {0, 0, 1, atlas.width, atlas.height},
                  std::as_bytes(std::span(atlas.texels)));
    return volumes_.insert(v);
}

Result<void> IrradianceStore::update(IrradianceVolumeHandle handle,
                                     const IrradianceVolume& volume) {
    const GpuIrradianceVolume* v = volumes_.find(handle);
    if (!v) return fail("irradiance volume", "the handle is stale or none.", ErrorKind::wrongUse);
    if (auto ok = checkIrradianceVolume(volume, "irradiance volume"); !ok) return ok;
    if (volume.grid.counts != v->grid.counts || volume.grid.origin != v->grid.origin ||
        volume.grid.spacing != v->grid.spacing)
        return fail("irradiance volume", "its grid is not the one that it was created with.",
                    ErrorKind::wrongUse);
    device_.write(v->records, 0, std::as_bytes(std::span(volume.records)));
    return {};
}

void IrradianceStore::destroy(IrradianceVolumeHandle handle) {
    const GpuIrradianceVolume* v = volumes_.find(handle);
    if (!v) return;
    release(*v);
    volumes_.erase(handle);
}

}  // namespace rushlight

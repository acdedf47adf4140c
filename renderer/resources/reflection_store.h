#pragma once
// The cubes of the reflection probes that frames show, in one array, and their records.

#include "renderer/frame/reflection_probes.h"
#include "renderer/geometry/view_math.h"
#include "renderer/resources/environment_store.h"

#include <array>
#include <vector>

namespace rushlight {

/// The indices of the probes that a frame shows, smaller boxes first.
void chooseReflectionProbes(std::span<const ReflectionProbe> probes, const CameraMatrices& camera,
                            std::vector<uint32_t>& chosen);

/// See interop/reflection_probe.h; `layers` are those of the chosen probes.
void writeReflectionRecords(std::span<const ReflectionProbe> probes,
                            std::span<const uint32_t> chosen, std::span<const uint32_t> layers,
                            const vec3& eye, std::vector<vec4>& records);

class ReflectionStore {
public:
    ReflectionStore(Device& device, const EnvironmentStore& environments)
        : device_(device), environments_(environments) {}
    ~ReflectionStore();
    ReflectionStore(const ReflectionStore&) = delete;
    ReflectionStore& operator=(const ReflectionStore&) = delete;

    /// Puts the cubes of what is in view into the array: a copy where it is new or was captured
    /// again, else nothing.
    Result<void> prepare(std::span<const ReflectionProbe> probes, const CameraMatrices& camera);

    // Of the last prepare.
    bool empty() const { return chosen_.empty(); }
    std::span<const vec4> records() const { return records_; }
    TextureHandle cubes() const { return cubes_; }
    TextureHandle irradiance() const { return irradiance_; }

private:
    struct Layer {
        uint64_t content = 0;  ///< GpuEnvironment::content; 0: none
        uint64_t lastUse = 0;
    };
    Result<void> grow(uint32_t count);
    uint32_t layerOf(const GpuEnvironment& environment);
    Result<TextureHandle> makeArray(const char* label, uint32_t size, uint32_t levels,
                                    uint32_t cubes);
    void copyInto(uint32_t layer, const GpuEnvironment& environment);
    void copyCube(TextureHandle from, TextureHandle to, uint32_t layer, uint32_t size,
                  uint32_t levels);
    void release();

    Device& device_;
    const EnvironmentStore& environments_;
    TextureHandle cubes_, irradiance_;
    uint32_t capacity_ = 0;
    std::array<Layer, kMaxShownReflectionProbes> layers_{};
    uint64_t use_ = 0;
    std::vector<uint32_t> chosen_, chosenLayers_;
    std::vector<vec4> records_;
    std::vector<std::byte> scratch_;
};

}  // namespace rushlight

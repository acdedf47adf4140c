#pragma once
// Checks of descriptions that every backend makes in the same words.

#include "engine/core/result.h"
#include "renderer/rhi/resources.h"

namespace rushlight {

struct DeviceLimits {
    uint32_t textureSize = 16384;
    uint32_t cubeSize = 16384;
    uint32_t textureLayers = 2048;
    uint64_t bufferSize = uint64_t(1) << 31;
};

// A size of zero, over the limit, or that does not fit the kind, is an Error that names the label.
Result<void> validate(const BufferDesc&, const DeviceLimits&);
Result<void> validate(const TextureDesc&, const DeviceLimits&);
Result<void> validate(const PipelineDesc&);

/// Bytes that `region` of a texture of `format` takes, tightly packed.
uint64_t byteSize(Format format, const TextureRegion& region);

}  // namespace rushlight

#pragma once
// An image as rays read it: colours made smaller, as a ray that gathers light sees no detail; alpha
// as it is, since a mask decides what casts a shadow.

#include "engine/core/result.h"
#include "renderer/frame/resource_descs.h"

#include <vector>

namespace rushlight {

class RayImage {
public:
    static constexpr uint32_t kMostColorSide = 256;

    /// Copies. An Error names the label when the sizes do not fit.
    static Result<RayImage> create(const ImageDesc& desc);

    /// Linear colour and alpha, bilinear, at a uv of `slot` before its transform.
    vec4 sample(const TextureSlot& slot, const vec2& uv) const;
    /// Alpha alone, of the full image.
    float sampleAlpha(const TextureSlot& slot, const vec2& uv) const;
    uint64_t bytes() const { return colors_.size() + alpha_.size(); }

private:
    float channel(uint8_t value) const;

    uvec2 size_{0};
    uvec2 alphaSize_{0};
    bool srgb_ = false;
    std::vector<uint8_t> colors_;
    std::vector<uint8_t> alpha_;  ///< empty: 1 everywhere
};

/// Where KHR_texture_transform takes a uv.
vec2 transformUv(const TextureSlot& slot, const vec2& uv);

}  // namespace rushlight

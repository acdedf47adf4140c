#pragma once

#include "renderer/frame/decals.h"
#include "renderer/rhi/device.h"

#include <array>
#include <vector>

namespace rushlight {

/// Pictures of decals as layers of two arrays, so that one binding of each serves all decals:
///
///                 r          g          b          a
///     color     [ base colour, sRGB              | cover    ]
///     detail    [ normal x | normal y | roughness | metallic ]
class DecalStore {
public:
    explicit DecalStore(Device& device) : device_(device) {}
    ~DecalStore();
    DecalStore(const DecalStore&) = delete;
    DecalStore& operator=(const DecalStore&) = delete;

    Result<DecalMaterialHandle> create(const DecalMaterialDesc&);
    void destroy(DecalMaterialHandle);
    /// The layer of both arrays; null for a stale handle.
    const uint32_t* find(DecalMaterialHandle material) const { return materials_.find(material); }

    TextureHandle color() const { return arrays_[0]; }
    TextureHandle detail() const { return arrays_[1]; }

private:
    using Levels = std::vector<std::vector<uint8_t>>;  ///< of one layer, kept to move it into
                                                       ///< larger arrays
    Result<void> grow(uint32_t layers);
    void upload(uint32_t layer);

    Device& device_;
    Pool<uint32_t, DecalMaterialTag> materials_;
    std::array<TextureHandle, 2> arrays_;
    uint32_t capacity_ = 0;
    std::vector<std::array<Levels, 2>> layers_;
    std::vector<uint32_t> freeLayers_;
};

}  // namespace rushlight

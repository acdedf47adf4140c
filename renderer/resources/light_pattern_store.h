#pragma once

#include "renderer/lighting/light_patterns.h"
#include "renderer/rhi/device.h"

#include <vector>

namespace rushlight {

/// Profiles and cookies as layers of one RGBA16F array with mip levels. Nothing is made before the
/// first one.
class LightPatternStore {
public:
    struct Entry {
        uint32_t layer = 0;
        float perRadian = 0;  ///< as LightPattern
    };

    explicit LightPatternStore(Device& device) : device_(device) {}
    ~LightPatternStore();
    LightPatternStore(const LightPatternStore&) = delete;
    LightPatternStore& operator=(const LightPatternStore&) = delete;

    Result<LightProfileHandle> create(const LightProfileDesc&);
    Result<LightCookieHandle> create(const LightCookieDesc&);
    void destroy(LightProfileHandle);
    void destroy(LightCookieHandle);
    /// Null for a stale handle.
    const Entry* find(LightProfileHandle profile) const { return profiles_.find(profile); }
    const Entry* find(LightCookieHandle cookie) const { return cookies_.find(cookie); }

    TextureHandle texture() const { return array_; }
    SamplerHandle sampler() const { return sampler_; }

private:
    using Levels = std::vector<std::vector<uint16_t>>;  ///< of one layer, kept to move it into a
                                                        ///< larger array
    Result<Entry> add(const LightPattern&);
    void release(uint32_t layer);
    Result<void> grow(uint32_t layers);
    void upload(uint32_t layer);

    Device& device_;
    Pool<Entry, LightProfileTag> profiles_;
    Pool<Entry, LightCookieTag> cookies_;
    TextureHandle array_;
    SamplerHandle sampler_;
    uint32_t capacity_ = 0;
    std::vector<Levels> layers_;
    std::vector<uint32_t> freeLayers_;
};

}  // namespace rushlight

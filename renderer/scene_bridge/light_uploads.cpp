#include "renderer/scene_bridge/light_uploads.h"

namespace rushlight {

LightUploads::~LightUploads() {
    for (const LightProfileHandle profile : profiles_)
        if (profile) renderer_.destroy(profile);
    for (const LightCookieHandle cookie : cookies_)
        if (cookie) renderer_.destroy(cookie);
}

Result<void> LightUploads::create() {
    profiles_.resize(model_.lightProfiles.size());
    cookies_.resize(model_.images.size());
    for (const assets::Light& light : model_.lights) {
        if (light.profile >= 0 && !profile(light.profile))
            if (auto made = createProfile(light.profile); !made) return made;
        if (light.cookie >= 0 && !cookie(light.cookie))
            if (auto made = createCookie(light.cookie); !made) return made;
    }
    return {};
}

Result<void> LightUploads::createProfile(int index) {
    const assets::LightProfile& from = model_.lightProfiles[size_t(index)];
    const LightProfileDesc desc{from.name, from.verticalAngles, from.horizontalAngles,
                                from.candela};
    auto pattern = LightPattern::make(desc);
    if (!pattern) return tl::unexpected(pattern.error());
    const auto handle = renderer_.createLightProfile(desc);
    if (!handle) return tl::unexpected(handle.error());
    profiles_[size_t(index)] = *handle;
    patterns_.set(*handle, std::move(*pattern));
    return {};
}

Result<void> LightUploads::createCookie(int image) {
    const assets::Image& from = model_.images[size_t(image)];
    const LightCookieDesc desc{from.name, {from.name, from.width, from.height, true, from.pixels}};
    auto pattern = LightPattern::make(desc);
    if (!pattern) return tl::unexpected(pattern.error());
    const auto handle = renderer_.createLightCookie(desc);
    if (!handle) return tl::unexpected(handle.error());
    cookies_[size_t(image)] = *handle;
    patterns_.set(*handle, std::move(*pattern));
    return {};
}

}  // namespace rushlight

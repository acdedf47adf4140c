#pragma once

#include "engine/assets/model.h"
#include "renderer/lighting/light_patterns.h"
#include "renderer/renderer.h"

#include <vector>

namespace rushlight {

/// The profiles and cookies of a model's lights in a renderer, each made once; and as rays look
/// them up.
class LightUploads {
public:
    LightUploads(Renderer& renderer, const assets::Model& model)
        : renderer_(renderer), model_(model) {}
    ~LightUploads();
    LightUploads(const LightUploads&) = delete;
    LightUploads& operator=(const LightUploads&) = delete;

    Result<void> create();
    /// Of Model::lightProfiles, and of the image Model::images; null for -1.
    LightProfileHandle profile(int index) const {
        return index < 0 ? LightProfileHandle{} : profiles_[size_t(index)];
    }
    LightCookieHandle cookie(int image) const {
        return image < 0 ? LightCookieHandle{} : cookies_[size_t(image)];
    }
    const LightPatternSet& patterns() const { return patterns_; }

private:
    Result<void> createProfile(int index);
    Result<void> createCookie(int image);

    Renderer& renderer_;
    const assets::Model& model_;
    std::vector<LightProfileHandle> profiles_;
    std::vector<LightCookieHandle> cookies_;
    LightPatternSet patterns_;
};

}  // namespace rushlight

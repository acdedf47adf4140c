#pragma once

#include "engine/assets/model.h"
#include "renderer/renderer.h"
#include "renderer/scene_bridge/resource_sink.h"

#include <map>
#include <vector>

namespace rushlight {

/// The images and materials of a model in a renderer. An image is uploaded when a material first
/// uses it: once as colour (sRGB) and once as data, or less.
class MaterialUploads {
public:
    MaterialUploads(Renderer& renderer, const assets::Model& model)
        : renderer_(renderer), model_(model), materials_(model.materials.size()) {}
    ~MaterialUploads();
    MaterialUploads(const MaterialUploads&) = delete;
    MaterialUploads& operator=(const MaterialUploads&) = delete;

    /// Of Model::materials; zero, the default material, for -1.
    Result<MaterialHandle> find(int material);
    /// What was uploaded: images, then materials.
    Result<void> describe(ResourceSink& sink);

private:
    ImageDesc imageDesc(int image, bool srgb) const;
    Result<MaterialDesc> materialDesc(int material);
    Result<void> setTexture(const assets::TextureUse&, bool srgb, TextureSlot&);
    Result<ImageHandle> findImage(int image, bool srgb);

    Renderer& renderer_;
    const assets::Model& model_;
    std::vector<MaterialHandle> materials_;
    std::map<std::pair<int, bool>, ImageHandle> images_;
};

}  // namespace rushlight

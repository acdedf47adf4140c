#pragma once
// Materials as packed texels of one buffer, and the sets of texture bindings that they share.

#include "renderer/frame/frame_input.h"
#include "renderer/resources/texture_store.h"
#include "renderer/rhi/device.h"
#include "shaders/interop/bindings.h"

#include <array>
#include <vector>

namespace rushlight {

/// Base colour, metallic-roughness, normal, occlusion, emissive, transmission
inline constexpr uint32_t kTextureSlots = 6;
inline constexpr std::array<uint32_t, kTextureSlots> kMaterialUnits = {
    RL_TEXTURE_BASE_COLOR, RL_TEXTURE_METALLIC_ROUGHNESS, RL_TEXTURE_NORMAL,
    RL_TEXTURE_OCCLUSION,  RL_TEXTURE_EMISSIVE,           RL_TEXTURE_TRANSMISSION};

struct TextureBinding {
    TextureHandle texture;
    SamplerHandle sampler;
    bool operator==(const TextureBinding&) const = default;
};
using TextureSet = std::array<TextureBinding, kTextureSlots>;

struct GpuMaterial {
    uint32_t surfaceFlags = 0;  ///< of surface_variant.h, from the material alone
    uint32_t texel = 0;         ///< where its MaterialData begins
    uint32_t textureSet = 0;
    bool operator==(const GpuMaterial&) const = default;
};

class MaterialStore {
public:
    MaterialStore(Device& device, TextureStore& textures);
    ~MaterialStore();
    MaterialStore(const MaterialStore&) = delete;
    MaterialStore& operator=(const MaterialStore&) = delete;

    Result<MaterialHandle> create(const MaterialDesc&);
    Result<void> update(MaterialHandle, const MaterialDesc&);
    void destroy(MaterialHandle);

    /// Uploads what changed; call after TextureStore::flush, with its answer.
    Result<void> flush(bool imagesMoved);

    /// glTF's default material for a zero handle, null for a stale one.
    const GpuMaterial* find(MaterialHandle material) const;
    /// What it was made of, without its label; as find().
    const MaterialDesc* describe(MaterialHandle material) const;
    const TextureSet& textureSet(uint32_t index) const { return sets_[index]; }
    BufferRange buffer() const;

    /// Created, destroyed, or with other GpuMaterial contents since clearChanges(); complete after
    /// flush().
    std::span<const MaterialHandle> changedMaterials() const { return changed_; }
    void clearChanges() { changed_.clear(); }

private:
    struct Stored {
        MaterialDesc desc;  ///< label left empty: it is the caller's memory
        GpuMaterial gpu;
    };
    Result<void> check(const MaterialDesc&) const;
    void pack(Stored&);
    uint32_t internSet(const TextureSet&);

    Device& device_;
    TextureStore& textures_;
    Pool<Stored, MaterialTag> materials_;
    MaterialHandle default_;
    std::vector<MaterialHandle> changed_;
    std::vector<uvec4> texels_;
    std::vector<TextureSet> sets_;
    BufferHandle buffer_;
    uint64_t bufferSize_ = 0;
    bool dirty_ = true;
};

}  // namespace rushlight

#include "renderer/resources/material_store.h"

#include "renderer/materials/surface_variant.h"
#include "shaders/interop/bindings.h"
#include "shaders/interop/surface_flags.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace rushlight {
namespace {

struct Slot {
    TextureSlot MaterialDesc::*texture;
    uint32_t flag;
    const char* name;
};
constexpr Slot kSlots[kTextureSlots] = {
    {&MaterialDesc::baseColorTexture, kBaseColorTexture, "base colour"},
    {&MaterialDesc::metallicRoughnessTexture, kMetallicRoughnessTexture, "metallic-roughness"},
    {&MaterialDesc::normalTexture, kNormalTexture, "normal"},
    {&MaterialDesc::occlusionTexture, kOcclusionTexture, "occlusion"},
    {&MaterialDesc::emissiveTexture, kEmissiveTexture, "emissive"},
    {&MaterialDesc::transmissionTexture, kTransmissionTexture, "transmission"},
};

bool isIdentity(const TextureSlot& slot) {
    return slot.offset == vec2(0) && slot.rotation == 0 && slot.scale == vec2(1);
}

bool sameLookup(const TextureSlot& a, const TextureSlot& b) {
    return a.image == b.image && a.sampler == b.sampler && a.uvSet == b.uvSet &&
           a.offset == b.offset && a.rotation == b.rotation && a.scale == b.scale;
}

uint32_t surfaceFlags(const MaterialDesc& desc) {
    uint32_t flags = 0;
    const bool transmits = desc.transmission > 0 && !desc.unlit;
    for (const Slot& slot : kSlots) {
        const TextureSlot& texture = desc.*slot.texture;
        if (!texture.image || (slot.flag == kTransmissionTexture && !transmits)) continue;
        flags |= slot.flag;
        if (texture.uvSet == 1) flags |= kSecondUv;
        if (!isIdentity(texture)) flags |= kUvTransforms;
    }
    if (desc.emissive == vec3(0))
        flags &= ~uint32_t(kEmissiveTexture);
    else
        flags |= kEmissive;
    if ((flags & kOcclusionTexture) && (flags & kMetallicRoughnessTexture) &&
        sameLookup(desc.occlusionTexture, desc.metallicRoughnessTexture))
        flags = (flags & ~uint32_t(kOcclusionTexture)) | kOcclusionInMetallicRoughness;
    if (desc.alphaMode == AlphaMode::mask) flags |= kAlphaMask;
    if (desc.alphaMode == AlphaMode::blend) flags |= kBlend;
    if (transmits) flags |= kBlend | kTransmission;
    if (desc.doubleSided) flags |= kDoubleSided;
    if (desc.unlit) {
        flags |= kUnlit;
        flags &= ~uint32_t(kTextureFlags & ~kBaseColorTexture);
        flags &= ~uint32_t(kOcclusionInMetallicRoughness | kEmissive);
    }
    return flags;
}

}  // namespace

MaterialStore::MaterialStore(Device& device, TextureStore& textures)
    : device_(device), textures_(textures) {
    sets_.emplace_back();
    default_ = *create(MaterialDesc{});
}

MaterialStore::~MaterialStore() {
    if (buffer_) device_.destroy(buffer_);
}

Result<void> MaterialStore::check(const MaterialDesc& desc) const {
    const std::string object = "material '" + std::string(desc.label) + "'";
    for (const Slot& slot : kSlots) {
        const TextureSlot& texture = desc.*slot.texture;
        if (texture.image && !textures_.has(texture.image))
            return fail(
                object,
                std::string("the image of its ") + slot.name + " texture is a stale handle.",
                ErrorKind::wrongUse);
        if (texture.uvSet > 1)
            return fail(object, std::string("its ") + slot.name + " texture uses UV set " +
                                    std::to_string(texture.uvSet) + "; there are 0 and 1.");
    }
    const vec4 base = desc.baseColor;
    const float sum = base.x + base.y + base.z + base.w + desc.metallic + desc.roughness +
                      desc.normalScale + desc.occlusionStrength + desc.emissive.x +
                      desc.emissive.y + desc.emissive.z + desc.alphaCutoff;
    if (!std::isfinite(sum)) return fail(object, "one of its factors is not finite.");
    const vec3 color = desc.transmissionColor;
    for (const float share : {desc.transmission, color.x, color.y, color.z})
        if (!(share >= 0 && share <= 1))
            return fail(object, "its transmission or a channel of the transmission's colour is " +
                                    std::to_string(share) + ", not within 0 to 1.");
    return {};
}

Result<MaterialHandle> MaterialStore::create(const MaterialDesc& desc) {
    if (auto ok = check(desc); !ok) return tl::unexpected(ok.error());
    Stored stored{desc, {}};
    stored.desc.label = {};
    stored.gpu.surfaceFlags = surfaceFlags(desc);
    dirty_ = true;
    changed_.push_back(materials_.insert(std::move(stored)));
    return changed_.back();
}

Result<void> MaterialStore::update(MaterialHandle handle, const MaterialDesc& desc) {
    Stored* stored = materials_.find(handle);
    if (!stored)
        return fail("material '" + std::string(desc.label) + "'", "the handle is stale or none.",
                    ErrorKind::wrongUse);
    if (auto ok = check(desc); !ok) return ok;
    stored->desc = desc;
    stored->desc.label = {};
    stored->gpu.surfaceFlags = surfaceFlags(desc);
    dirty_ = true;
    changed_.push_back(handle);
    return {};
}

void MaterialStore::destroy(MaterialHandle handle) {
    if (handle == default_ || !materials_.erase(handle)) return;
    changed_.push_back(handle);
}

const GpuMaterial* MaterialStore::find(MaterialHandle handle) const {
    const Stored* stored = materials_.find(handle ? handle : default_);
    return stored ? &stored->gpu : nullptr;
}

const MaterialDesc* MaterialStore::describe(MaterialHandle handle) const {
    const Stored* stored = materials_.find(handle ? handle : default_);
    return stored ? &stored->desc : nullptr;
}

BufferRange MaterialStore::buffer() const { return {buffer_, 0, 0, bufferSize_}; }

uint32_t MaterialStore::internSet(const TextureSet& set) {
    const auto found = std::find(sets_.begin(), sets_.end(), set);
    if (found != sets_.end()) return uint32_t(found - sets_.begin());
    sets_.push_back(set);
    return uint32_t(sets_.size() - 1);
}

// Layout: shaders/interop/surface_flags.h.
void MaterialStore::pack(Stored& stored) {
    MaterialDesc& desc = stored.desc;
    for (const Slot& slot : kSlots)  // an image that was destroyed leaves its materials
        if (TextureSlot& texture = desc.*slot.texture; !textures_.has(texture.image))
            texture.image = {};
    stored.gpu.surfaceFlags = surfaceFlags(desc);
    const auto half2 = [](float x, float y) { return glm::packHalf2x16(vec2(x, y)); };
    TextureSet set{};
    std::array<uint32_t, kTextureSlots> layers{};
    uint32_t uvSets = 0;
    for (uint32_t i = 0; i < kTextureSlots; ++i) {
        const TextureSlot& texture = desc.*kSlots[i].texture;
        const ImageLocation* place = textures_.find(texture.image);
        if (!place || !(stored.gpu.surfaceFlags & kSlots[i].flag)) continue;
        set[i] = {place->array, device_.createSampler(texture.sampler)};
        layers[i] = place->layer;
        uvSets |= uint32_t(texture.uvSet) << i;
    }
    stored.gpu.textureSet = internSet(set);
    stored.gpu.texel = uint32_t(texels_.size());
    const vec3 emissive = glm::min(desc.emissive, vec3(65504.0f));
    texels_.push_back({half2(desc.baseColor.x, desc.baseColor.y),
                       half2(desc.baseColor.z, desc.baseColor.w),
                       glm::packUnorm2x16(vec2(desc.metallic, desc.roughness)),
                       half2(desc.normalScale, desc.occlusionStrength)});
    texels_.push_back({half2(emissive.x, emissive.y), half2(emissive.z, desc.alphaCutoff),
                       layers[0] | layers[1] << 10 | layers[2] << 20,
                       layers[3] | layers[4] << 10 | uvSets << 20});
    const bool transmits = stored.gpu.surfaceFlags & kTransmission;
    if (transmits) {
        const vec3 color = desc.transmissionColor;
        const float alphaCovers = desc.alphaMode == AlphaMode::blend ? 1.0f : 0.0f;
        texels_.push_back({half2(desc.transmission, alphaCovers), half2(color.x, color.y),
                           half2(color.z, 0), layers[5]});
    }
    if (!(stored.gpu.surfaceFlags & kUvTransforms)) return;
    for (const Slot& slot : std::span(kSlots).first(transmits ? 6 : 5)) {
        const TextureSlot& t = desc.*slot.texture;
        const float c = std::cos(t.rotation), s = std::sin(t.rotation);
        // KHR_texture_transform: uv' = translation * rotation * scale * uv, rotation
        // counter-clockwise in image space
        const auto bits = [](float x) { return std::bit_cast<uint32_t>(x); };
        texels_.push_back(
            {bits(c * t.scale.x), bits(-s * t.scale.x), bits(s * t.scale.y), bits(c * t.scale.y)});
        texels_.push_back({bits(t.offset.x), bits(t.offset.y), 0, 0});
    }
}

Result<void> MaterialStore::flush(bool imagesMoved) {
    if (!dirty_ && !imagesMoved) return {};
    texels_.clear();
    sets_.resize(1);
    materials_.forEach([&](MaterialHandle handle, Stored& stored) {
        const GpuMaterial before = stored.gpu;
        pack(stored);
        if (stored.gpu != before) changed_.push_back(handle);
    });
    const uint64_t size = texels_.size() * sizeof(uvec4);
    if (size > bufferSize_) {
        if (buffer_) device_.destroy(std::exchange(buffer_, {}));
        bufferSize_ = 0;
        auto buffer = device_.createBuffer({"materials", size * 2, BufferUsage::texel});
        if (!buffer) return tl::unexpected(buffer.error());
        buffer_ = *buffer;
        bufferSize_ = size * 2;
    }
    device_.write(buffer_, 0, std::as_bytes(std::span(texels_)));
    dirty_ = false;
    return {};
}

}  // namespace rushlight

#pragma once
// What commands name, as somebody who holds it describes it: a device, or a frame in a file.

#include "renderer/rhi/resources.h"

#include <array>
#include <optional>
#include <span>

namespace rushlight {

/// What a texture unit is read as.
enum class SampledAs : uint8_t {
    nothing,
    texture2d,
    texture2dArray,
    cube,
    cubeArray,
    floatTexels,    ///< samplerBuffer
    integerTexels,  ///< usamplerBuffer
    other,          ///< of a kind that no command binds
};

inline constexpr uint32_t kUniformSlots = 8;
inline constexpr uint32_t kTextureUnits = 32;
inline constexpr uint32_t kVertexStreams = 4;

/// What a pipeline's program reads besides its vertices.
struct PipelineSlots {
    std::array<uint32_t, kUniformSlots> uniformBytes{};  ///< of the block at a slot; 0: none
    std::array<SampledAs, kTextureUnits> textures{};
    std::array<bool, kTextureUnits> compares{};  ///< a shadow sampler
};

/// Nothing for a handle that is none, stale or foreign. Texts in the answers are good until an
/// object is created, destroyed or compiled again.
class ResourceLookup {
public:
    virtual ~ResourceLookup() = default;
    virtual std::optional<BufferDesc> describe(BufferHandle) const = 0;
    virtual std::optional<TextureDesc> describe(TextureHandle) const = 0;
    virtual std::optional<SamplerDesc> describe(SamplerHandle) const = 0;
    /// With the sources, without the defines: those are in the sources.
    virtual std::optional<PipelineDesc> describe(PipelineHandle) const = 0;
    /// Null where nobody knows.
    virtual const PipelineSlots* slots(PipelineHandle) const { return nullptr; }
    /// All bytes of a buffer, without a handle of the commands' data block; nothing where they are
    /// not at hand.
    virtual std::optional<std::span<const std::byte>> contents(BufferHandle) const { return {}; }
};

}  // namespace rushlight

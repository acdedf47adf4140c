#pragma once
// A frame as a value: its commands and all that they need to be played again, with no scene and no
// shader files.

#include "renderer/rhi/commands/command_buffer.h"
#include "renderer/rhi/saved/blob_store.h"

#include <string>
#include <vector>

namespace rushlight {

struct SavedBuffer {
    std::string label;
    uint64_t size = 0;
    BufferUsage usage = BufferUsage::vertex;
    uint32_t contents = 0;  ///< number of the blob
};

struct SavedTexture {
    std::string label;
    TextureDesc desc;  ///< without its label
    /// Numbers of blobs by mipLevel * layers + layer, as they were before the frame; 0: the frame
    /// writes it before it reads it.
    std::vector<uint32_t> contents;
};

struct SavedPipeline {
    std::string label, vertexShader, fragmentShader;
    PipelineDesc desc;                              ///< without its texts
    uint32_t vertexSource = 0, fragmentSource = 0;  ///< numbers of blobs; 0: none was known
};

/// Handles in `commands` are positions in the lists below, from 1; so are tickets of readbacks
/// among themselves.
struct SavedFrame final : ResourceLookup {
    FrameTarget target;  ///< without its framebuffer
    CommandBuffer commands;
    std::vector<SavedBuffer> buffers;
    std::vector<SavedTexture> textures;
    std::vector<SamplerDesc> samplers;
    std::vector<SavedPipeline> pipelines;
    BlobStore blobs;

    std::optional<BufferDesc> describe(BufferHandle) const override;
    std::optional<TextureDesc> describe(TextureHandle) const override;
    std::optional<SamplerDesc> describe(SamplerHandle) const override;
    std::optional<PipelineDesc> describe(PipelineHandle) const override;
    std::optional<std::span<const std::byte>> contents(BufferHandle) const override;
};

}  // namespace rushlight

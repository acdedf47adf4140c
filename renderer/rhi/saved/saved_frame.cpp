#include "renderer/rhi/saved/saved_frame.h"

namespace rushlight {
namespace {

template <class T, class AnyHandle>
const T* find(const std::vector<T>& list, AnyHandle handle) {
    return handle && handle.value <= list.size() ? &list[handle.value - 1] : nullptr;
}

}  // namespace

std::optional<BufferDesc> SavedFrame::describe(BufferHandle handle) const {
    const SavedBuffer* found = find(buffers, handle);
    if (!found) return {};
    return BufferDesc{found->label, found->size, found->usage};
}

std::optional<TextureDesc> SavedFrame::describe(TextureHandle handle) const {
    const SavedTexture* found = find(textures, handle);
    if (!found) return {};
    TextureDesc desc = found->desc;
    desc.label = found->label;
    return desc;
}

std::optional<SamplerDesc> SavedFrame::describe(SamplerHandle handle) const {
    const SamplerDesc* found = find(samplers, handle);
    if (!found) return {};
    return *found;
}

std::optional<PipelineDesc> SavedFrame::describe(PipelineHandle handle) const {
    const SavedPipeline* found = find(pipelines, handle);
    if (!found) return {};
    const auto text = [&](uint32_t number) {
        if (!number) return std::string_view();
        const std::span<const std::byte> bytes = blobs.bytes(number);
        return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    };
    PipelineDesc desc = found->desc;
    desc.label = found->label;
    desc.vertexShader = found->vertexShader;
    desc.fragmentShader = found->fragmentShader;
    desc.vertexSource = text(found->vertexSource);
    desc.fragmentSource = text(found->fragmentSource);
    return desc;
}

std::optional<std::span<const std::byte>> SavedFrame::contents(BufferHandle handle) const {
    if (!handle) return commands.data();
    const SavedBuffer* found = find(buffers, handle);
    if (!found || !found->contents) return {};
    return blobs.bytes(found->contents);
}

}  // namespace rushlight

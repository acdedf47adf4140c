#include "renderer/replay/snapshot.h"

#include "renderer/rhi/commands/command_stream.h"
#include "renderer/rhi/saved/needed_contents.h"

namespace rushlight {
namespace {

class Snapshot {
    template <class AnyHandle>
    auto described(AnyHandle handle) const {
        const auto desc = device_.describe(handle);
        RL_CHECK(desc, "a command names an object that does not exist");
        return *desc;
    }

public:
    Snapshot(Device& device, const CommandBuffer& commands)
        : device_(device), needed_(neededContents(commands, device)) {}

    SavedFrame frame;

    BufferHandle map(BufferHandle handle) {
        return number(buffers_, handle, [&] { add(handle); });
    }
    TextureHandle map(TextureHandle handle) {
        return number(textures_, handle, [&] { add(handle); });
    }
    SamplerHandle map(SamplerHandle handle) {
        return number(samplers_, handle, [&] { frame.samplers.push_back(described(handle)); });
    }
    PipelineHandle map(PipelineHandle handle) {
        return number(pipelines_, handle, [&] { add(handle); });
    }

private:
    /// Numbers objects in the order in which the commands name them.
    template <class AnyHandle, class Add>
    static AnyHandle number(std::map<AnyHandle, uint32_t>& numbers, AnyHandle handle, Add&& add) {
        const auto [place, fresh] = numbers.try_emplace(handle, uint32_t(numbers.size() + 1));
        if (fresh) add();
        return {place->second};
    }
    void add(BufferHandle handle) {
        const BufferDesc desc = described(handle);
        std::vector<std::byte> bytes(desc.size);
        device_.read(handle, 0, bytes);
        frame.buffers.push_back(
            {std::string(desc.label), desc.size, desc.usage, frame.blobs.add(std::move(bytes))});
    }

    void add(TextureHandle handle) {
        SavedTexture texture;
        texture.desc = described(handle);
        texture.label = texture.desc.label;
        texture.desc.label = {};
        const std::vector<bool>& needed = needed_[handle];
        texture.contents.resize(needed.size());
        for (uint32_t i = 0; i < needed.size(); ++i) {
            if (!needed[i]) continue;
            const uint32_t level = i / texture.desc.layers, layer = i % texture.desc.layers;
            std::vector<std::byte> bytes(imageBytes(texture.desc, level));
            device_.read(handle, level, layer, bytes);
            texture.contents[i] = frame.blobs.add(std::move(bytes));
        }
        frame.textures.push_back(std::move(texture));
    }

    void add(PipelineHandle handle) {
        SavedPipeline pipeline;
        pipeline.desc = described(handle);
        PipelineDesc& d = pipeline.desc;
        pipeline.label = d.label;
        pipeline.vertexShader = d.vertexShader;
        pipeline.fragmentShader = d.fragmentShader;
        pipeline.vertexSource = source(d.vertexSource);
        pipeline.fragmentSource = source(d.fragmentSource);
        d.label = d.vertexShader = d.fragmentShader = d.vertexSource = d.fragmentSource = {};
        frame.pipelines.push_back(std::move(pipeline));
    }
    uint32_t source(std::string_view text) {
        const auto bytes = std::as_bytes(std::span(text));
        return bytes.empty() ? 0 : frame.blobs.add({bytes.begin(), bytes.end()});
    }

    Device& device_;
    std::map<TextureHandle, std::vector<bool>> needed_;
    std::map<BufferHandle, uint32_t> buffers_;
    std::map<TextureHandle, uint32_t> textures_;
    std::map<SamplerHandle, uint32_t> samplers_;
    std::map<PipelineHandle, uint32_t> pipelines_;
};

}  // namespace

SavedFrame takeSnapshot(Device& device, const CommandBuffer& commands, const FrameTarget& target) {
    Snapshot snapshot(device, commands);
    uint32_t tickets = 0;
    translateCommands(commands, snapshot.frame.commands, [&]<class Command>(Command& command) {
        mapHandles(command, [&](auto handle) { return snapshot.map(handle); });
        if constexpr (std::is_same_v<Command, Readback>) command.ticket = ++tickets;
    });
    snapshot.frame.target = target;
    snapshot.frame.target.framebuffer = 0;
    return std::move(snapshot.frame);
}

}  // namespace rushlight

#include "renderer/backend/null/null_device.h"

#include "renderer/rhi/validate.h"

#include <algorithm>
#include <chrono>

namespace rushlight {
namespace {

// Descriptions with the texts that they were made with.
struct NullTexture : TextureDesc {
    std::string text;
};
struct NullBuffer : BufferDesc {
    std::string text;
};
struct NullPipeline : PipelineDesc {
    std::string texts[5];
};

template <class Kept, class Desc>
std::optional<Desc> describeKept(const Kept* kept) {
    if (!kept) return {};
    Desc desc = *kept;
    desc.label = kept->text;
    return desc;
}
struct PendingReadback {
    uint32_t ticket;
    Format format;
    uint32_t width, height;
};

struct NullState {
    Pool<NullBuffer, BufferTag> buffers;
    Pool<NullTexture, TextureTag> textures;
    Pool<SamplerDesc, SamplerTag> samplers;
    Pool<NullPipeline, PipelineTag> pipelines;
    std::vector<PendingReadback> readbacks;
};

/// Walks one frame's commands: checks what they name, and counts.
class Counter {
public:
    Counter(NullState& state, const CommandBuffer& commands, const ExecuteOptions& options,
            ExecutionReport& report)
        : state_(state), dataSize_(commands.data().size()), options_(options), report_(report) {}

    void operator()(const BeginPass& c) {
        RL_CHECK(!pass_, "a pass begins inside of another");
        callsBefore_ = report_.glCalls++;
        changesBefore_ = report_.stateChanges;
        if (report_.passes.size() <= c.passIndex) report_.passes.resize(c.passIndex + 1);
        pass_ = &report_.passes[c.passIndex];
        if (!c.toFrameTarget)
            for (uint32_t i = 0; i < c.colorCount; ++i)
                if (c.colors[i].texture) checkTexture(c.colors[i].texture);
        if (!c.toFrameTarget && c.depth.texture) checkTexture(c.depth.texture);
        const uint32_t depths = c.depth.texture && !c.toFrameTarget ? 1 : 0;
        if (options_.hashAttachments)
            pass_->attachmentHashes.assign(c.toFrameTarget ? 1 : c.colorCount + depths, 0);
        if (options_.keepAttachments) keepAttachments(c);
    }
    void operator()(const DeclareImage& c) { checkTexture(c.texture); }
    void operator()(const EndPass&) {
        ++report_.glCalls;
        RL_CHECK(pass_, "a pass ends that did not begin");
        pass_->glCalls = report_.glCalls - callsBefore_;
        pass_->stateChanges = report_.stateChanges - changesBefore_;
        pass_ = nullptr;
        pipeline_ = nullptr;
    }
    void operator()(const SetPipeline& c) {
        changeState();
        pipeline_ = state_.pipelines.find(c.pipeline);
        RL_CHECK(pipeline_, "a command names a pipeline that does not exist");
    }
    void operator()(const SetViewport&) { changeState(); }
    void operator()(const SetScissor&) { changeState(); }
    void operator()(const SetVertexStream& c) { changeState(), checkRange(c.range); }
    void operator()(const SetIndexStream& c) { changeState(), checkRange(c.range); }
    void operator()(const BindUniforms& c) { changeState(), checkRange(c.range); }
    void operator()(const BindTexelBuffer& c) { changeState(), checkRange(c.range); }
    void operator()(const BindTexture& c) {
        changeState();
        if (c.texture) checkTexture(c.texture);
        RL_CHECK(!c.sampler || state_.samplers.find(c.sampler),
                 "a command names a sampler that does not exist");
    }
    void operator()(const Draw& c) { count(1, uint64_t(c.vertexCount / 3) * c.instanceCount); }
    void operator()(const DrawIndexed& c) {
        count(1, uint64_t(c.command.indexCount / 3) * c.command.instanceCount);
    }
    void operator()(const MultiDrawIndexed& c) {
        checkRange(c.commands);
        RL_CHECK(c.commands.size >= uint64_t(c.drawCount) * sizeof(DrawIndexedCommand),
                 "a multi-draw reads beyond its commands");
        count(c.drawCount, c.triangleCount);
    }
    void operator()(const Readback& c) {
        ++report_.glCalls;
        if (!c.texture) {
            state_.readbacks.push_back(
                {c.ticket, Format::rgba8, options_.target.width, options_.target.height});
            return;
        }
        const NullTexture& texture = checkTexture(c.texture);
        RL_CHECK(c.mipLevel < texture.mipLevels && c.layer < texture.layers,
                 "a readback names a mip level or layer that does not exist");
        state_.readbacks.push_back({c.ticket, texture.format, mipSize(texture.width, c.mipLevel),
                                    mipSize(texture.height, c.mipLevel)});
    }

private:
    void keepAttachments(const BeginPass& c) {
        const auto keep = [&](Format format, uint32_t width, uint32_t height) {
            const size_t bytes = size_t(bytesPerTexel(format)) * width * height;
            pass_->attachments.push_back({format, width, height, std::vector<std::byte>(bytes)});
        };
        if (c.toFrameTarget) return keep(Format::rgba8, c.width, c.height);
        const auto keepTexture = [&](TextureHandle handle, uint32_t mip) {
            const NullTexture& texture = checkTexture(handle);
            keep(texture.format, mipSize(texture.width, mip), mipSize(texture.height, mip));
        };
        for (uint32_t i = 0; i < c.colorCount; ++i)
            if (c.colors[i].texture) keepTexture(c.colors[i].texture, c.colors[i].mipLevel);
        if (c.depth.texture) keepTexture(c.depth.texture, 0);
    }
    void changeState() {
        ++report_.glCalls;
        ++report_.stateChanges;
    }
    const NullTexture& checkTexture(TextureHandle handle) {
        const NullTexture* texture = state_.textures.find(handle);
        RL_CHECK(texture, "a command names a texture that does not exist");
        return *texture;
    }
    void checkRange(const BufferRange& range) {
        const NullBuffer* buffer = state_.buffers.find(range.buffer);
        RL_CHECK(!range.buffer || buffer, "a command names a buffer that does not exist");
        const uint64_t size = buffer ? buffer->size : dataSize_;
        RL_CHECK(range.offset <= size && range.size <= size - range.offset,
                 "a command names a range outside of its buffer");
    }
    void count(uint32_t draws, uint64_t triangles) {
        RL_CHECK(pass_ && pipeline_, "a draw needs an open pass and a pipeline");
        ++report_.glCalls;
        pass_->draws += draws;
        pass_->triangles += pipeline_->lines ? 0 : triangles;
    }

    NullState& state_;
    uint64_t dataSize_;
    const ExecuteOptions& options_;
    ExecutionReport& report_;
    PassExecution* pass_ = nullptr;
    uint32_t callsBefore_ = 0, changesBefore_ = 0;
    const NullPipeline* pipeline_ = nullptr;
};

class NullDevice final : public Device {
public:
    std::string_view name() const override { return "null"; }
    std::string_view version() const override { return "accepts everything, draws nothing"; }

    Result<BufferHandle> createBuffer(const BufferDesc& desc) override {
        return validate(desc, {}).map([&] {
            return state_.buffers.insert({desc, std::string(desc.label)});
        });
    }
    Result<TextureHandle> createTexture(const TextureDesc& desc) override {
        return validate(desc, {}).map([&] {
            return state_.textures.insert({desc, std::string(desc.label)});
        });
    }
    SamplerHandle createSampler(const SamplerDesc& desc) override {
        SamplerHandle equal;
        state_.samplers.forEach([&](SamplerHandle handle, const SamplerDesc& existing) {
            if (existing == desc) equal = handle;
        });
        return equal ? equal : state_.samplers.insert(desc);
    }
    Result<PipelineHandle> createPipeline(const PipelineDesc& desc) override {
        return validate(desc).map([&] {
            const auto copy = [](std::string_view text) { return std::string(text); };
            return state_.pipelines.insert(
                {desc,
                 {copy(desc.label), copy(desc.vertexShader), copy(desc.fragmentShader),
                  copy(desc.vertexSource), copy(desc.fragmentSource)}});
        });
    }

    std::optional<BufferDesc> describe(BufferHandle handle) const override {
        return describeKept<NullBuffer, BufferDesc>(state_.buffers.find(handle));
    }
    std::optional<TextureDesc> describe(TextureHandle handle) const override {
        return describeKept<NullTexture, TextureDesc>(state_.textures.find(handle));
    }
    std::optional<SamplerDesc> describe(SamplerHandle handle) const override {
        const SamplerDesc* found = state_.samplers.find(handle);
        return found ? std::optional(*found) : std::nullopt;
    }
    std::optional<PipelineDesc> describe(PipelineHandle handle) const override {
        const NullPipeline* found = state_.pipelines.find(handle);
        if (!found) return {};
        PipelineDesc desc = *found;
        desc.label = found->texts[0];
        desc.vertexShader = found->texts[1];
        desc.fragmentShader = found->texts[2];
        desc.vertexSource = found->texts[3];
        desc.fragmentSource = found->texts[4];
        desc.defines = {};
        return desc;
    }
    void destroy(BufferHandle handle) override { state_.buffers.erase(handle); }
    void destroy(TextureHandle handle) override { state_.textures.erase(handle); }

    void write(BufferHandle handle, uint64_t offset, std::span<const std::byte> data) override {
        const NullBuffer* buffer = state_.buffers.find(handle);
        RL_CHECK(buffer, "a write names a buffer that does not exist");
        RL_CHECK(offset <= buffer->size && data.size() <= buffer->size - offset,
                 "a write goes beyond the end of its buffer");
    }
    void write(TextureHandle handle, const TextureRegion& region,
               std::span<const std::byte> data) override {
        const NullTexture* texture = state_.textures.find(handle);
        RL_CHECK(texture, "a write names a texture that does not exist");
        RL_CHECK(data.size() == byteSize(texture->format, region),
                 "a texture write has not the bytes of its region");
    }
    void copy(BufferHandle from, BufferHandle to, uint64_t size) override {
        const NullBuffer* source = state_.buffers.find(from);
        const NullBuffer* destination = state_.buffers.find(to);
        RL_CHECK(source && destination, "a copy names a buffer that does not exist");
        RL_CHECK(size <= source->size && size <= destination->size,
                 "a copy goes beyond the end of a buffer");
    }
    void read(BufferHandle handle, uint64_t offset, std::span<std::byte> out) override {
        const NullBuffer* buffer = state_.buffers.find(handle);
        RL_CHECK(buffer, "a read names a buffer that does not exist");
        RL_CHECK(offset <= buffer->size && out.size() <= buffer->size - offset,
                 "a read goes beyond the end of its buffer");
        std::ranges::fill(out, std::byte(0));
    }
    void read(TextureHandle handle, uint32_t mipLevel, uint32_t layer,
              std::span<std::byte> out) override {
        const NullTexture* texture = state_.textures.find(handle);
        RL_CHECK(texture && mipLevel < texture->mipLevels && layer < texture->layers,
                 "a read names a texture, mip level or layer that does not exist");
        RL_CHECK(out.size() == imageBytes(*texture, mipLevel),
                 "a texture read has not the bytes of its image");
        std::ranges::fill(out, std::byte(0));
    }
    void execute(const CommandBuffer& commands, const ExecuteOptions& options,
                 ExecutionReport& report) override {
        using Clock = std::chrono::steady_clock;
        report.begin();
        report.uploadedBytes = commands.data().size();
        visitCommands(commands, Counter(state_, commands, options, report));
        report.cpuMs = std::chrono::duration<double, std::milli>(Clock::now() - report.began)
                           .count();
    }
    bool takeReadback(uint32_t ticket, bool, ReadbackImage& image) override {
        const auto found = std::ranges::find(state_.readbacks, ticket, &PendingReadback::ticket);
        if (found == state_.readbacks.end()) return false;
        image.format = found->format;
        image.width = found->width;
        image.height = found->height;
        image.bytes.assign(size_t(bytesPerTexel(image.format)) * image.width * image.height,
                           std::byte(0));
        state_.readbacks.erase(found);
        return true;
    }
    Result<uint32_t> reloadShaders() override { return 0u; }
    void finish() override {}
    std::vector<std::string> takeDebugMessages() override { return {}; }

private:
    NullState state_;
};

}  // namespace

std::unique_ptr<Device> createNullDevice() { return std::make_unique<NullDevice>(); }

}  // namespace rushlight

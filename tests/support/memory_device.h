#pragma once
// The null device, with the contents of its buffers and textures kept for tests to look at.

#include "renderer/backend/null/null_device.h"

#include <algorithm>
#include <cstring>
#include <map>

namespace rushlight {

class MemoryDevice final : public Device {
public:
    struct Upload {
        TextureHandle texture;
        TextureRegion region;
        std::vector<std::byte> data;
    };
    std::map<BufferHandle, std::vector<std::byte>> buffers;
    std::map<TextureHandle, TextureDesc> textures;  ///< alive; labels are not kept
    std::vector<Upload> uploads;
    uint32_t pipelines = 0;  ///< created so far
    uint64_t compiledPrograms() const override { return pipelines; }

    template <class T>
    T read(BufferHandle buffer, size_t index) const {
        T value;
        std::memcpy(&value, buffers.at(buffer).data() + index * sizeof(T), sizeof(T));
        return value;
    }

    std::string_view name() const override { return "memory"; }
    std::string_view version() const override { return ""; }
    Result<BufferHandle> createBuffer(const BufferDesc& desc) override {
        auto made = null_->createBuffer(desc);
        if (made) buffers[*made].assign(desc.size, std::byte(0xcd));
        return made;
    }
    Result<TextureHandle> createTexture(const TextureDesc& desc) override {
        auto made = null_->createTexture(desc);
        if (made) (textures[*made] = desc).label = {};
        return made;
    }
    SamplerHandle createSampler(const SamplerDesc& desc) override {
        return null_->createSampler(desc);
    }
    Result<PipelineHandle> createPipeline(const PipelineDesc& desc) override {
        ++pipelines;
        return null_->createPipeline(desc);
    }
    void destroy(BufferHandle buffer) override { buffers.erase(buffer), null_->destroy(buffer); }
    void destroy(TextureHandle texture) override {
        textures.erase(texture), null_->destroy(texture);
    }
    void write(BufferHandle buffer, uint64_t offset, std::span<const std::byte> data) override {
        null_->write(buffer, offset, data);
        std::ranges::copy(data, buffers.at(buffer).begin() + std::ptrdiff_t(offset));
    }
    void write(TextureHandle texture, const TextureRegion& region,
               std::span<const std::byte> data) override {
        null_->write(texture, region, data);
        uploads.push_back({texture, region, {data.begin(), data.end()}});
    }
    void copy(BufferHandle from, BufferHandle to, uint64_t size) override {
        null_->copy(from, to, size);
        std::copy_n(buffers.at(from).begin(), size, buffers.at(to).begin());
    }
    std::optional<BufferDesc> describe(BufferHandle b) const override { return null_->describe(b); }
    std::optional<TextureDesc> describe(TextureHandle t) const override {
        return null_->describe(t);
    }
    std::optional<SamplerDesc> describe(SamplerHandle s) const override {
        return null_->describe(s);
    }
    std::optional<PipelineDesc> describe(PipelineHandle p) const override {
        return null_->describe(p);
    }
    void read(BufferHandle buffer, uint64_t offset, std::span<std::byte> out) override {
        null_->read(buffer, offset, out);
        std::copy_n(buffers.at(buffer).begin() + std::ptrdiff_t(offset), out.size(), out.begin());
    }
    /// What was last written to the image as a whole; zeroes where nothing was.
    void read(TextureHandle texture, uint32_t mipLevel, uint32_t layer,
              std::span<std::byte> out) override {
        null_->read(texture, mipLevel, layer, out);
        for (const Upload& upload : uploads) {
            const TextureRegion& r = upload.region;
            if (upload.texture == texture && r.mipLevel == mipLevel && layer >= r.layer &&
                layer - r.layer < r.layerCount && upload.data.size() == out.size() * r.layerCount)
                std::copy_n(upload.data.begin() + std::ptrdiff_t((layer - r.layer) * out.size()),
                            out.size(), out.begin());
        }
    }
    void execute(const CommandBuffer& commands, const ExecuteOptions& options,
                 ExecutionReport& report) override {
        null_->execute(commands, options, report);
    }
    bool takeReadback(uint32_t ticket, bool wait, ReadbackImage& image) override {
        return null_->takeReadback(ticket, wait, image);
    }
    Result<uint32_t> reloadShaders() override { return 0u; }
    void finish() override {}
    std::vector<std::string> takeDebugMessages() override { return {}; }

private:
    std::unique_ptr<Device> null_ = createNullDevice();
};

}  // namespace rushlight

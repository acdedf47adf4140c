#pragma once
// The null device, with what was executed noted, and a gate to hold it up.

#include "engine/core/hash.h"
#include "renderer/backend/null/null_device.h"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace rushlight {

class FrameRecorder final : public Device {
public:
    struct Gate {
        void set(bool open) {
            const std::lock_guard lock(mutex);
            isOpen = open;
            changed.notify_all();
        }
        void pass() {
            std::unique_lock lock(mutex);
            changed.wait(lock, [&] { return isOpen; });
        }
        std::mutex mutex;
        std::condition_variable changed;
        bool isOpen = true;
    };
    struct Log {
        std::vector<uint64_t> frames;  ///< a hash of the commands as text and of the data
        std::vector<std::thread::id> threads;
        Gate gate;  ///< every frame goes through it
        Result<void> status;
    };
    explicit FrameRecorder(Log& log) : log_(log) {}

    std::string_view name() const override { return "recorder"; }
    std::string_view version() const override { return ""; }
    Result<BufferHandle> createBuffer(const BufferDesc& d) override {
        return null_->createBuffer(d);
    }
    Result<TextureHandle> createTexture(const TextureDesc& d) override {
        return null_->createTexture(d);
    }
    SamplerHandle createSampler(const SamplerDesc& d) override { return null_->createSampler(d); }
    Result<PipelineHandle> createPipeline(const PipelineDesc& d) override {
        return null_->createPipeline(d);
    }
    void destroy(BufferHandle buffer) override { null_->destroy(buffer); }
    void destroy(TextureHandle texture) override { null_->destroy(texture); }
    void write(BufferHandle buffer, uint64_t offset, std::span<const std::byte> data) override {
        null_->write(buffer, offset, data);
    }
    void write(TextureHandle t, const TextureRegion& region,
               std::span<const std::byte> data) override {
        null_->write(t, region, data);
    }
    void copy(BufferHandle from, BufferHandle to, uint64_t size) override {
        null_->copy(from, to, size);
    }
    void read(BufferHandle buffer, uint64_t offset, std::span<std::byte> out) override {
        null_->read(buffer, offset, out);
    }
    void read(TextureHandle texture, uint32_t level, uint32_t layer,
              std::span<std::byte> out) override {
        null_->read(texture, level, layer, out);
    }
    std::optional<BufferDesc> describe(BufferHandle h) const override { return null_->describe(h); }
    std::optional<TextureDesc> describe(TextureHandle h) const override {
        return null_->describe(h);
    }
    std::optional<SamplerDesc> describe(SamplerHandle h) const override {
        return null_->describe(h);
    }
    std::optional<PipelineDesc> describe(PipelineHandle h) const override {
        return null_->describe(h);
    }
    void execute(const CommandBuffer& commands, const ExecuteOptions& options,
                 ExecutionReport& report) override {
        log_.gate.pass();
        log_.frames.push_back(
            hashBytes(commands.data().data(), commands.data().size(), hashText(print(commands))));
        log_.threads.push_back(std::this_thread::get_id());
        null_->execute(commands, options, report);
    }
    Result<void> status() const override { return log_.status; }
    bool takeReadback(uint32_t ticket, bool wait, ReadbackImage& image) override {
        return null_->takeReadback(ticket, wait, image);
    }
    Result<uint32_t> reloadShaders() override { return 0u; }
    void finish() override {}
    std::vector<std::string> takeDebugMessages() override { return {}; }

private:
    Log& log_;
    std::unique_ptr<Device> null_ = createNullDevice();
};

}  // namespace rushlight

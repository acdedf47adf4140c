#pragma once
// A device whose calls another thread makes: the render-thread mode. One thread, the one on which
// the context is current, is in serve(); another builds frames and calls everything else. A frame
// is handed over and executed later; a destruction is queued behind the frames; every other call
// waits until the serving thread has made it, in order, so it is for loading. There is one mutex,
// taken at the hand-over alone, and no thread is started here.

#include "renderer/rhi/device.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>

namespace rushlight {

class ThreadedDevice final : public Device {
public:
    /// `frames`: how many may be handed over and not yet executed; execute() waits where there are
    /// that many.
    ThreadedDevice(std::unique_ptr<Device> device, uint32_t frames);

    /// Executes what comes until stopServing(); then does what is left and returns.
    /// `afterFrame(user)` is called after each frame into the host's framebuffer: the place to swap
    /// buffers. An Error when a thread serves already.
    Result<void> serve(void (*afterFrame)(void* user), void* user);
    /// Ends serve() and waits until it has left, unless called from within it. Before serve(): it
    /// ends at once.
    void stopServing();

    /// Around calls of the thread that builds frames, as many as belong together: until leave()
    /// serving goes on. Before the first serve() it waits for that, unless on the thread that made
    /// this object: there, as on the one that served last, calls are made at once while no thread
    /// serves. An Error from elsewhere after stopServing(), on the serving thread while it serves,
    /// and between enter() and leave().
    Result<void> enter();
    void leave();

    std::string_view name() const override { return device_->name(); }
    std::string_view version() const override { return device_->version(); }
    Result<BufferHandle> createBuffer(const BufferDesc& desc) override {
        return call([&] { return device_->createBuffer(desc); });
    }
    Result<TextureHandle> createTexture(const TextureDesc& desc) override {
        return call([&] { return device_->createTexture(desc); });
    }
    SamplerHandle createSampler(const SamplerDesc& desc) override {
        return call([&] { return device_->createSampler(desc); });
    }
    Result<PipelineHandle> createPipeline(const PipelineDesc& desc) override {
        return call([&] { return device_->createPipeline(desc); });
    }
    void destroy(BufferHandle buffer) override;
    void destroy(TextureHandle texture) override;
    void write(BufferHandle buffer, uint64_t offset, std::span<const std::byte> data) override {
        call([&] { device_->write(buffer, offset, data); });
    }
    void write(TextureHandle texture, const TextureRegion& region,
               std::span<const std::byte> data) override {
        call([&] { device_->write(texture, region, data); });
    }
    void copy(BufferHandle from, BufferHandle to, uint64_t size) override {
        call([&] { device_->copy(from, to, size); });
    }
    void read(BufferHandle buffer, uint64_t offset, std::span<std::byte> out) override {
        call([&] { device_->read(buffer, offset, out); });
    }
    void read(TextureHandle texture, uint32_t mipLevel, uint32_t layer,
              std::span<std::byte> out) override {
        call([&] { device_->read(texture, mipLevel, layer, out); });
    }
    void runInOrder(void (*f)(void* closure), void* closure) override {
        call([&] { f(closure); });
    }
    std::optional<BufferDesc> describe(BufferHandle h) const override {
        return described<BufferDesc>(h);
    }
    std::optional<TextureDesc> describe(TextureHandle h) const override {
        return described<TextureDesc>(h);
    }
    std::optional<SamplerDesc> describe(SamplerHandle h) const override {
        return described<SamplerDesc>(h);
    }
    std::optional<PipelineDesc> describe(PipelineHandle h) const override {
        return described<PipelineDesc>(h);
    }
    const PipelineSlots* slots(PipelineHandle h) const override {
        return const_cast<ThreadedDevice*>(this)->call([&] { return device_->slots(h); });
    }
    void execute(const CommandBuffer& commands, const ExecuteOptions& options,
                 ExecutionReport& report) override;
    uint64_t compiledPrograms() const override { return device_->compiledPrograms(); }
    uint32_t maxPendingFrames() const override { return maxPending_; }
    uint32_t pendingFrames() const override;
    /// Without `wait` it is asked for between two frames, ahead of those that queue.
    bool takeReadback(uint32_t ticket, bool wait, ReadbackImage& image) override {
        return call([&] { return device_->takeReadback(ticket, wait, image); }, !wait);
    }
    Result<uint32_t> reloadShaders() override {
        return call([&] { return device_->reloadShaders(); });
    }
    void finish() override {
        call([&] { device_->finish(); });
    }
    Result<void> status() const override;
    Result<void> takeFailure() override;
    std::vector<std::string> takeDebugMessages() override {
        return call([&] { return device_->takeDebugMessages(); });
    }

private:
    struct Call {
        void (*run)(void* closure) = nullptr;
        void* closure = nullptr;
        bool done = false;
    };
    struct Job {  // one of the four
        const CommandBuffer* frame = nullptr;
        Call* call = nullptr;
        BufferHandle buffer = {};
        TextureHandle texture = {};
        ExecuteOptions options = {};  // of `frame`
        ExecutionReport* report = nullptr;
    };
    using Lock = std::unique_lock<std::mutex>;

    /// Runs `f` on the serving thread and gives back what it returns.
    template <class F>
    std::invoke_result_t<F> call(F&& f, bool ahead = false);
    template <class Desc, class Handle>
    std::optional<Desc> described(Handle handle) const {
        return const_cast<ThreadedDevice*>(this)->call([&] { return device_->describe(handle); });
    }
    void waitFor(Call& call, bool ahead);
    bool hasServer() const;
    void push(const Job& job, bool ahead = false);
    std::optional<Job> pop();
    void run(const Job& job);
    void serveJobs(Lock& lock, void (*afterFrame)(void* user), void* user);

    const std::unique_ptr<Device> device_;
    const uint32_t maxPending_;

    mutable std::mutex mutex_;  // of all below
    std::condition_variable toServer_, toCaller_;
    std::vector<Job> jobs_;  // from `firstJob_` on; the memory is kept
    size_t firstJob_ = 0;
    uint32_t pending_ = 0;
    uint32_t synchronousCalls_ = 0;  // since the last execute()
    bool serving_ = false, stopping_ = false, entered_ = false;
    uint64_t sessions_ = 0;                               // how often serve() was begun
    std::thread::id owner_ = std::this_thread::get_id();  // who serves, or did last, or made this
    Result<void> status_, failure_;
};

template <class F>
std::invoke_result_t<F> ThreadedDevice::call(F&& f, bool ahead) {
    using R = std::invoke_result_t<F>;
    if (!hasServer()) return f();
    Call one;
    const auto wait = [&](auto& closure) {
        using Closure = std::remove_reference_t<decltype(closure)>;
        one.closure = &closure;
        one.run = [](void* erased) { (*static_cast<Closure*>(erased))(); };
        waitFor(one, ahead);
    };
    if constexpr (std::is_void_v<R>) {
        wait(f);
    } else {
        std::optional<R> result;
        auto body = [&] { result.emplace(f()); };
        wait(body);
        return std::move(*result);
    }
}

}  // namespace rushlight

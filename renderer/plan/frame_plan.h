#pragma once
// A frame as passes with declared reads and writes. Passes run in the order they are added; the
// plan checks that every read has an earlier writer, drops passes that nobody needs, gives
// transient images to textures from a pool (two images whose lives do not overlap share one), and
// records the passes, on any number of threads, into one buffer. All memory is kept from frame to
// frame.

#include "engine/core/jobs.h"
#include "engine/core/result.h"
#include "renderer/frame/frame_report.h"
#include "renderer/rhi/commands/command_buffer.h"
#include "renderer/rhi/device.h"

#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

namespace rushlight {

struct ImageId {
    uint32_t value = ~0u;
    explicit operator bool() const { return value != ~0u; }
    bool operator==(const ImageId&) const = default;
};

struct PlanImage {
    const char* name = "";  ///< static storage; shown by `--hashes` and in the report
    Format format = Format::none;
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t layers = 1;
    bool array = false;  ///< sampled as an array even with one layer
};
bool sameShape(const PlanImage& a, const PlanImage& b);
Result<TextureHandle> createTexture(Device& device, const PlanImage& image);

class FramePlan;

/// A pass as it is described. Each call declares an access and makes the binding that goes with it,
/// so that nothing can be bound that was not declared. A null image and an empty range are ignored.
/// Good until the next pass is begun.
class PassBuilder {
public:
    // Targets.
    PassBuilder& color(ImageId image, LoadOp load = LoadOp::discard, const vec4& clear = vec4(0),
                       uint32_t layer = 0);
    PassBuilder& depth(ImageId image, LoadOp load, uint32_t layer = 0);
    /// Tested and not written; the pass may sample it too.
    PassBuilder& depthTest(ImageId image, uint32_t layer = 0);
    /// The host's framebuffer: such a pass is always needed.
    PassBuilder& frameTarget(uint32_t width, uint32_t height);

    // What shaders read, by the slots of shaders/interop/bindings.h.
    PassBuilder& sample(uint32_t slot, ImageId image, SamplerHandle sampler);
    PassBuilder& texture(uint32_t slot, TextureHandle texture, SamplerHandle sampler);
    PassBuilder& uniforms(uint32_t slot, const BufferRange& range);
    PassBuilder& texels(uint32_t slot, Format format, const BufferRange& range);

    /// What the pass draws: `function(payload, commands)` is called once, perhaps on another
    /// thread, after compile(). The payload is copied.
    template <class Payload>
    void record(const Payload& payload, void (*function)(const Payload&, CommandBuffer&));
    /// One triangle over the targets.
    void fullscreen(PipelineHandle pipeline);

private:
    friend class FramePlan;
    explicit PassBuilder(FramePlan& plan) : plan_(plan) {}
    FramePlan& plan_;
};

class FramePlan {
public:
    static constexpr uint32_t kMaxWanted = 8;

    explicit FramePlan(Device& device) : device_(device) {}
    ~FramePlan();
    FramePlan(const FramePlan&) = delete;
    FramePlan& operator=(const FramePlan&) = delete;

    void begin();

    /// An image that lives within the frame.
    ImageId createImage(const PlanImage&);
    /// An image that outlives the frame; writing it is needed by definition.
    ImageId importImage(const PlanImage&, TextureHandle);

    /// `name` has static storage. The pass is what its builder is told until the next is begun.
    PassBuilder addPass(const char* name);

    /// Keeps an image alive to the end and marks it needed: it is read back.
    void requestImage(ImageId image);

    // Images by name, for pictures of what a frame makes on its way. Who asks does so before the
    // passes are added; who makes an image on demand asks whether it is wanted.

    /// At most kMaxWanted. `name` has static storage.
    void want(const char* name);
    bool wants(std::string_view name) const;
    /// `image`, as the passes added so far leave it. Where it is wanted, passes that write it
    /// afterwards are dropped.
    void publish(const char* name, ImageId image);
    /// Null where nothing was published under that name.
    ImageId find(std::string_view name) const;

    /// Checks, drops and allocates. An Error names the pass and the image. `orderSeed` is 0 for the
    /// order in which passes were added; else it picks another one that their accesses allow.
    Result<void> compile(uint64_t orderSeed = 0);

    /// Records every kept pass and appends them in order.
    void record(JobSystem& jobs, CommandBuffer& out);

    TextureHandle texture(ImageId image) const { return images_[image.value].texture; }

    // For the report, after compile(): kept passes in order.
    uint32_t keptPassCount() const { return uint32_t(kept_.size()); }
    const char* passName(uint32_t kept) const { return passes_[kept_[kept]].name; }
    uint32_t passBytesPerPixel(uint32_t kept) const;
    template <class F>
    void forEachRead(uint32_t kept, F&& f) const {
        const Pass& pass = passes_[kept_[kept]];
        for (const Binding& binding : bindingsOf(pass))
            if (binding.kind == Binding::sampled) f(images_[binding.image.value].desc.name);
    }
    /// `f(PassImage)`, without texels.
    template <class F>
    void forEachWrite(uint32_t kept, F&& f) const {
        const Pass& pass = passes_[kept_[kept]];
        const auto written = [&](ImageId id, uint32_t layer) {
            const PlanImage& image = images_[id.value].desc;
            f(PassImage{image.name, image.format, image.width, image.height, layer, {}});
        };
        for (uint32_t i = 0; i < pass.colorCount; ++i)
            written(pass.colors[i].image, pass.colors[i].layer);
        if (pass.depth.image && !pass.depth.readOnly) written(pass.depth.image, pass.depth.layer);
        if (pass.toFrameTarget)
            f(PassImage{"frame-target", Format::rgba8, pass.frameWidth, pass.frameHeight, 0, {}});
    }

private:
    friend class PassBuilder;
    using Caller = void (*)(void (*)(), const void*, CommandBuffer&);

    struct Color {
        ImageId image;
        LoadOp load = LoadOp::discard;
        vec4 clear{0};
        uint32_t layer = 0;
    };
    struct Depth {
        ImageId image;
        LoadOp load = LoadOp::keep;
        uint32_t layer = 0;
        bool readOnly = false;
    };
    struct Binding {
        enum Kind : uint8_t { sampled, outside, uniforms, texels };
        Kind kind = sampled;
        Format format = Format::none;  ///< of texels
        uint32_t slot = 0;
        ImageId image;          ///< sampled
        TextureHandle texture;  ///< outside
        SamplerHandle sampler;
        BufferRange range;
    };
    struct Pass {
        const char* name = "";
        Color colors[kMaxColorAttachments];
        uint32_t colorCount = 0;
        Depth depth;
        size_t firstBinding = 0;  ///< of bindings_
        size_t bindingCount = 0;
        bool toFrameTarget = false;
        uint32_t frameWidth = 0, frameHeight = 0;
        size_t payload = 0;  ///< offset into payloads_
        void (*function)() = nullptr;
        Caller caller = nullptr;
        bool needed = false;
    };
    struct Image {
        PlanImage desc;
        TextureHandle texture;
        bool imported = false;
        bool requested = false;
        size_t sealedAt = ~size_t(0);  ///< passes from here on may not write it
        uint32_t firstPass = 0, lastPass = 0;
        int poolSlot = -1;
    };
    struct Published {
        std::string_view name;
        ImageId image;
    };
    struct PooledTexture {
        PlanImage desc;
        TextureHandle texture;
        bool inUse = false;
        uint32_t unusedFrames = 0;
    };

    /// The one that is being described.
    Pass& openPass() { return passes_.back(); }
    void bind(const Binding& binding);
    void setRecord(const void* payload, size_t size, void (*function)(), Caller caller);
    std::span<const Binding> bindingsOf(const Pass& pass) const {
        return std::span(bindings_).subspan(pass.firstBinding, pass.bindingCount);
    }
    Result<void> checkOrder();
    void dropUnneeded();
    bool writesSealed(size_t pass) const;
    void shuffle(uint64_t seed);
    bool mustFollow(const Pass& later, const Pass& earlier) const;
    Result<void> allocate();
    Result<TextureHandle> acquire(Image& image);
    void recordPass(uint32_t kept, CommandBuffer& commands) const;
    void declareImages(const Pass& pass, CommandBuffer& commands) const;
    void recordBindings(const Pass& pass, CommandBuffer& commands) const;

    Device& device_;
    std::vector<Pass> passes_;
    std::vector<Image> images_;
    std::vector<Binding> bindings_;
    std::vector<std::byte> payloads_;
    std::vector<uint32_t> kept_;
    std::vector<PooledTexture> pool_;
    std::vector<CommandBuffer> recordings_;
    std::vector<bool> writtenScratch_;
    std::vector<std::string_view> wanted_;
    std::vector<Published> published_;
};

template <class Payload>
void PassBuilder::record(const Payload& payload, void (*function)(const Payload&, CommandBuffer&)) {
    static_assert(std::is_trivially_copyable_v<Payload>);
    plan_.setRecord(&payload, sizeof payload, reinterpret_cast<void (*)()>(function),
                    [](void (*erased)(), const void* data, CommandBuffer& commands) {
                        Payload copy;
                        std::memcpy(static_cast<void*>(&copy), data, sizeof copy);
                        reinterpret_cast<void (*)(const Payload&, CommandBuffer&)>(erased)(
                            copy, commands);
                    });
}

}  // namespace rushlight

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
#include <span>
#include <string_view>
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

/// What a pass's record function may touch: its commands, and the images that it declared.
class PassContext {
public:
    CommandBuffer& commands;

    /// Stops the program when the pass did not declare the image: that is a bug in the pass.
    TextureHandle texture(ImageId image) const;

    PassContext(CommandBuffer& buffer, const FramePlan& plan, uint32_t pass)
        : commands(buffer), plan_(plan), pass_(pass) {}

private:
    const FramePlan& plan_;
    uint32_t pass_;
};

/// A pass's targets and reads; a null image is ignored.
struct PassTargets {
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
        bool readOnly = false;  ///< depth test without writes; the pass may sample it too
    };
    std::span<const Color> colors;
    Depth depth;
    std::span<const ImageId> reads;
    bool toFrameTarget = false;  ///< draws into the host's framebuffer: such a pass is always
                                 ///< needed
    uint32_t frameWidth = 0;
    uint32_t frameHeight = 0;
};

class FramePlan {
public:
    static constexpr uint32_t kMaxReads = 12;
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

    /// `function(payload, context)` is called once, perhaps on another thread, after compile(). The
    /// payload is copied.
    template <class Payload>
    void addPass(const char* name, const PassTargets& targets, const Payload& payload,
                 void (*function)(const Payload&, PassContext&)) {
        static_assert(std::is_trivially_copyable_v<Payload>);
        addPass(name, targets, &payload, sizeof payload, reinterpret_cast<void (*)()>(function),
                [](void (*erased)(), const void* data, PassContext& context) {
                    Payload copy;
                    std::memcpy(static_cast<void*>(&copy), data, sizeof copy);
                    reinterpret_cast<void (*)(const Payload&, PassContext&)>(erased)(copy, context);
                });
    }

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

    /// Checks, drops and allocates. An Error names the pass and the image.
    Result<void> compile();

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
        for (uint32_t i = 0; i < pass.readCount; ++i) f(images_[pass.reads[i].value].desc.name);
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
    friend class PassContext;
    using Caller = void (*)(void (*)(), const void*, PassContext&);

    struct Pass {
        const char* name;
        PassTargets::Color colors[kMaxColorAttachments];
        uint32_t colorCount;
        PassTargets::Depth depth;
        ImageId reads[kMaxReads];
        uint32_t readCount;
        bool toFrameTarget;
        uint32_t frameWidth, frameHeight;
        size_t payload;  ///< offset into payloads_
        void (*function)();
        Caller caller;
        bool needed;
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

    void addPass(const char* name, const PassTargets&, const void* payload, size_t size,
                 void (*function)(), Caller caller);
    Result<void> checkOrder();
    void dropUnneeded();
    bool writesSealed(size_t pass) const;
    Result<void> allocate();
    Result<TextureHandle> acquire(Image& image);
    void recordPass(uint32_t kept, CommandBuffer& commands) const;
    void declareImages(const Pass& pass, CommandBuffer& commands) const;
    bool declared(uint32_t pass, ImageId image) const;

    Device& device_;
    std::vector<Pass> passes_;
    std::vector<Image> images_;
    std::vector<std::byte> payloads_;
    std::vector<uint32_t> kept_;
    std::vector<PooledTexture> pool_;
    std::vector<CommandBuffer> recordings_;
    std::vector<bool> writtenScratch_;
    std::vector<std::string_view> wanted_;
    std::vector<Published> published_;
};

}  // namespace rushlight

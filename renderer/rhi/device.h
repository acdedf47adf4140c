#pragma once
// What the passes and the frame builder ask of a GPU. backend/gl implements it on OpenGL 4.5,
// backend/null accepts everything and counts. One thread at a time; for GL, the thread on which the
// context is current.

#include "engine/core/result.h"
#include "renderer/rhi/commands/command_buffer.h"
#include "renderer/rhi/resources.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace rushlight {

/// A texture's texels, rows from v = 0, tightly packed in `format`.
struct ReadbackImage {
    Format format = Format::none;
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<std::byte> bytes;
};

inline constexpr uint64_t kNoFrame = ~uint64_t(0);

/// What one pass cost. Times are milliseconds, begins since the execution began. What it takes to
/// look into a pass is no part of it.
struct PassExecution {
    uint32_t draws = 0;  ///< draws as the GPU sees them: each entry of a multi-draw counts
    uint64_t triangles = 0;
    uint32_t glCalls = 0;
    uint32_t stateChanges = 0;
    double cpuBeginMs = 0;
    double cpuMs = 0;       ///< of submitting it
    double gpuBeginMs = 0;  ///< since the execution of ExecutionReport::gpuFrame began, by the
                            ///< CPU's clock
    double gpuMs = 0;  ///< from timer queries of the latest frame that is finished; 0 with no GPU
    std::vector<uint64_t> attachmentHashes;  ///< when ExecuteOptions::hashAttachments: colours in
                                             ///< order, then depth
    std::vector<ReadbackImage> attachments;  ///< when ExecuteOptions::keepAttachments, in the same
                                             ///< order
};

struct ExecutionReport {
    std::vector<PassExecution> passes;  ///< by BeginPass::passIndex
    uint32_t glCalls = 0;  ///< every call into the API, uploads of the data block included; more
                           ///< than all passes'
    uint32_t stateChanges = 0;  ///< calls that bind or set state, after redundant ones are dropped
    uint64_t uploadedBytes = 0;
    uint32_t waits = 0;       ///< times the CPU waited for the GPU to be done with a frame's memory
    uint32_t queueWaits = 0;  ///< times execute() waited because too many frames were pending
    uint32_t synchronousCalls = 0;  ///< that waited for the serving thread since the last execute()
    std::chrono::steady_clock::time_point began;
    double cpuMs = 0;
    uint64_t gpuFrame = kNoFrame;  ///< ExecuteOptions::frame of the frame that the passes' GPU
                                   ///< times are of

    /// Of a frame that is about to be executed; its memory stays, and what the caller counts (the
    /// queue's) too.
    void begin() {
        began = std::chrono::steady_clock::now();
        for (PassExecution& pass : passes) {
            pass.draws = pass.glCalls = pass.stateChanges = 0;
            pass.triangles = 0;
            pass.cpuBeginMs = pass.cpuMs = pass.gpuBeginMs = pass.gpuMs = 0;
            pass.attachmentHashes.clear();
            pass.attachments.clear();
        }
        glCalls = stateChanges = waits = 0;
        uploadedBytes = 0;
        cpuMs = 0;
    }
};

struct ExecuteOptions {
    FrameTarget target;
    uint64_t frame = kNoFrame;     ///< its number, for ExecutionReport::gpuFrame
    bool hashAttachments = false;  ///< slow: reads every pass's attachments back
    bool keepAttachments = false;  ///< as slow
    bool timers = true;
    bool debugGroups = true;
    bool toHost = true;  ///< draws into the host's framebuffer, which shows it next
};

/// Its descriptions are those that the objects were made from; a texture's and a buffer's contents
/// are read back.
class Device : public ResourceLookup {
public:
    virtual std::string_view name() const = 0;     ///< e.g. GL_RENDERER
    virtual std::string_view version() const = 0;  ///< e.g. GL_VERSION

    // Creating. A size of zero or over the driver's limit is an Error that names the label.
    virtual Result<BufferHandle> createBuffer(const BufferDesc&) = 0;
    virtual Result<TextureHandle> createTexture(const TextureDesc&) = 0;
    virtual SamplerHandle createSampler(const SamplerDesc&) = 0;  ///< equal descriptions give equal
                                                                  ///< handles
    /// Compiles and links at once; the Error holds the driver's log with file names and lines.
    virtual Result<PipelineHandle> createPipeline(const PipelineDesc&) = 0;

    /// Programs that createPipeline() had to compile so far; those from a cache on disk and those
    /// that pipelines share are not counted. From any thread.
    virtual uint64_t compiledPrograms() const { return 0; }

    virtual void destroy(BufferHandle) = 0;  ///< waits until no frame in flight uses it
    virtual void destroy(TextureHandle) = 0;

    // Filling, outside of frames.
    virtual void write(BufferHandle, uint64_t offset, std::span<const std::byte> data) = 0;
    virtual void write(TextureHandle, const TextureRegion&, std::span<const std::byte> data) = 0;
    /// Copies `size` bytes between buffers; used to grow shared ones.
    virtual void copy(BufferHandle from, BufferHandle to, uint64_t size) = 0;

    // Looking into, outside of frames; waits for the GPU. What was never written may hold anything.
    virtual void read(BufferHandle, uint64_t offset, std::span<std::byte> out) = 0;
    /// One image of a texture, as TextureRegion has it; `out` has exactly its size.
    virtual void read(TextureHandle, uint32_t mipLevel, uint32_t layer,
                      std::span<std::byte> out) = 0;

    /// Runs a frame: copies its data block into this frame's slot of a persistently mapped ring
    /// (waiting, and counting the wait, if the GPU still uses it), then its commands. `report`
    /// keeps its memory from frame to frame. A device may return before it has executed the frame:
    /// commands and report must stay, untouched, while pendingFrames() counts them. On a lost
    /// device nothing happens.
    virtual void execute(const CommandBuffer&, const ExecuteOptions&, ExecutionReport& report) = 0;

    virtual uint32_t maxPendingFrames() const { return 0; }
    /// Frames that execute() has taken and that are not executed, the newest ones. The reports of
    /// others are complete.
    virtual uint32_t pendingFrames() const { return 0; }

    /// An Error once the device is lost (its context was reset): everything must be made again on a
    /// new one.
    virtual Result<void> status() const { return {}; }

    /// Why a frame was not executed to its end, once: the first since the last call. Memory was
    /// refused, or a framebuffer; what it was to write is not written.
    virtual Result<void> takeFailure() { return {}; }

    /// The image of a Readback command with this ticket; false while the GPU is not done, unless
    /// `wait`. Never of a frame that failed, nor where the driver has no memory for it.
    virtual bool takeReadback(uint32_t ticket, bool wait, ReadbackImage& image) = 0;

    /// Compiles pipelines again whose shader sources changed. On an error the last good program
    /// stays in use and the error is returned. Returns the number of programs replaced.
    virtual Result<uint32_t> reloadShaders() = 0;

    /// Runs `f(closure)` where the device's calls are made, in order with them; returns when that
    /// is done.
    virtual void runInOrder(void (*f)(void* closure), void* closure) { f(closure); }

    /// Blocks until the GPU has done everything.
    virtual void finish() = 0;

    /// GL debug messages of severity medium and up since the last call; tests expect none.
    virtual std::vector<std::string> takeDebugMessages() = 0;
};

}  // namespace rushlight

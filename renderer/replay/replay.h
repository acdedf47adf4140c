#pragma once
// Plays a SavedFrame on a device.

#include "renderer/rhi/device.h"
#include "renderer/rhi/saved/saved_frame.h"

#include <memory>
#include <string>
#include <vector>

namespace rushlight {

struct ReplayOptions {
    uint32_t until = ~0u;  ///< only so many commands, from the first; a pass that is open then is
                           ///< ended
    bool hashAttachments = false;
};

/// An attachment after its pass, as `--hashes` prints it.
struct AttachmentHash {
    std::string pass, image;
    uint64_t hash = 0;
};

class FrameReplay {
public:
    /// Makes the frame's objects on `device`, which must outlive the replay. `frame` (from
    /// decodeFrame or takeSnapshot) must, too. An Error names the object by its label.
    static Result<std::unique_ptr<FrameReplay>> create(Device& device, const SavedFrame& frame);
    ~FrameReplay();

    /// Puts the contents back and executes. The picture is that of the frame's last readback, else
    /// the frame target; with `until` the first colour target of the pass in which it stops, or its
    /// depth. ErrorKind::wrongUse when nothing was drawn up to there.
    Result<ReadbackImage> run(const ReplayOptions& options);

    /// Of the last run, with ReplayOptions::hashAttachments.
    const std::vector<AttachmentHash>& hashes() const { return hashes_; }
    /// Rows of the picture come from the top first: FrameTarget::topRowFirst, of a frame target.
    bool topRowFirst() const { return topRowFirst_; }

private:
    FrameReplay(Device& device, const SavedFrame& frame) : device_(device), frame_(frame) {}
    Result<void> createObjects();
    Result<void> createFrameTarget();
    void writeContents();
    /// The frame's first `until` commands for this device, and one readback.
    void translate(uint32_t until);
    void drawToOwnTarget(BeginPass& pass) const;
    void readLastPass();
    void mapObject(BufferHandle& handle) const;
    void mapObject(TextureHandle& handle) const;
    void mapObject(SamplerHandle& handle) const;
    void mapObject(PipelineHandle& handle) const;
    void collectHashes(const ExecutionReport& report);

    Device& device_;
    const SavedFrame& frame_;
    std::vector<BufferHandle> buffers_;
    std::vector<TextureHandle> textures_;
    std::vector<SamplerHandle> samplers_;
    std::vector<PipelineHandle> pipelines_;
    TextureHandle frameTarget_;  ///< in place of the host's framebuffer
    CommandBuffer commands_;
    BeginPass lastPass_;
    bool passOpen_ = false;
    bool topRowFirst_ = false;
    std::vector<AttachmentHash> hashes_;
};

}  // namespace rushlight

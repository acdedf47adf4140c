#pragma once
// Frames A to B of a scene with a fixed clock, into a file each.

#include "renderer/capture/image_files.h"
#include "sandbox/tool/options.h"
#include "sandbox/tool/render_setup.h"
#include "sandbox/tool/stats.h"

#include <functional>
#include <string>

namespace rushlight::tool {

struct SequenceOptions {
    std::string output;  ///< as for frameFileName
    FrameRange frames;
    Shard shard;
    float framesPerSecond = 30;
    float startTime = 0;  ///< seconds, of frame 0
    uvec2 size{0};
    EncodeEffort effort = EncodeEffort::fast;
    bool resume = false;  ///< frames that are there, whole and by the same key, are kept
    bool write = true;    ///< false: frames are drawn and read back only, to see what writing costs
    std::string key;      ///< of all that decides what the frames show
};

struct SequenceCounts {
    uint32_t rendered = 0, kept = 0;
    uint32_t writerWaits = 0;  ///< frames that waited for the file of an earlier one
    double seconds = 0;        ///< from the first frame's start to the last file's end
};

/// What a frame shows depends on its number alone, not on the frames before it, so that any number
/// of shards and resumed runs write the same bytes.
class Sequence {
public:
    using Input = std::function<FrameInput()>;  ///< of the setup's current time
    using Drawn = std::function<void(const FrameReport&)>;

    Sequence(const SequenceOptions& options, RenderSetup& setup, Input input)
        : options_(options), setup_(setup), input_(std::move(input)) {}

    /// `drawn` is called after each frame. An Error where a file cannot be written: those before it
    /// are there.
    Result<SequenceCounts> run(const FrameOptions& options, const Drawn& drawn);
    /// Of the last frame.
    const FrameTimes& times() const { return times_; }
    double firstFrameMs() const { return firstFrameMs_; }

private:
    bool isFinished(const std::string& path) const;
    Result<void> poseAt(uint64_t frame, bool follows);

    const SequenceOptions& options_;
    RenderSetup& setup_;
    Input input_;
    FrameTimes times_;
    double firstFrameMs_ = -1;
};

}  // namespace rushlight::tool

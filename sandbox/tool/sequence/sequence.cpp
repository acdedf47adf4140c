#include "sandbox/tool/sequence/sequence.h"

#include "engine/core/check.h"
#include "renderer/capture/image_files.h"
#include "sandbox/allocations.h"
#include "sandbox/tool/output_names.h"
#include "sandbox/tool/progress.h"
#include "sandbox/tool/sequence/frame_writer.h"

#include <chrono>
#include <filesystem>

namespace rushlight::tool {
namespace {

using Clock = std::chrono::steady_clock;

constexpr size_t kMostWaiting = 3;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A frame that the GPU may still be drawing.
struct Pending {
    CaptureTicket ticket;
    std::string path;
};

}  // namespace

// A file that was cut short, or is of another scene or other options, does not count.
bool Sequence::isFinished(const std::string& path) const {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return false;
    const auto picture = loadPicture(path);
    return picture && picture->width == options_.size.x && picture->height == options_.size.y &&
           picture->description == options_.key;
}

// Where things were one frame before decides what moves.
Result<void> Sequence::poseAt(uint64_t frame, bool follows) {
    const auto secondsOf = [&](double number) {
        return float(double(options_.startTime) + number / double(options_.framesPerSecond));
    };
    if (!follows)
        if (auto posed = setup_.setTime(secondsOf(double(frame) - 1)); !posed) return posed;
    return setup_.setTime(secondsOf(double(frame)));
}

Result<SequenceCounts> Sequence::run(const FrameOptions& options, const Drawn& drawn) {
    const uint64_t all = uint64_t(options_.frames.last) - options_.frames.first + 1;
    const uint64_t begin = options_.frames.first +
                           all * (options_.shard.index - 1) / options_.shard.count;
    const uint64_t end = options_.frames.first + all * options_.shard.index / options_.shard.count;
    const bool linear = *imageFormatOf(options_.output) == ImageFormat::exr;
    Renderer& renderer = setup_.renderer();
    SequenceCounts counts;
    FrameWriter writer(kMostWaiting, options_.effort);
    Pending pending;
    CapturedImage image;
    const auto fetch = [&]() -> Result<void> {
        if (!pending.ticket) return {};
        const bool taken = renderer.takeCapture(pending.ticket, true, image);
        RL_CHECK(taken, "a capture that is waited for arrives");
        pending.ticket = {};
        if (!options_.write) return {};
        return writer.write(std::move(pending.path), image, options_.key);
    };
    const auto start = Clock::now();
    const Progress progress("frame");
    bool follows = false;
    for (uint64_t frame = begin; frame < end; ++frame) {
        auto path = frameFileName(options_.output, uint32_t(frame));
        if (!path) return tl::unexpected(path.error());
        if (options_.resume && isFinished(*path)) {
            ++counts.kept;
            follows = false;
            continue;
        }
        if (auto posed = poseAt(frame, follows); !posed) return tl::unexpected(posed.error());
        follows = true;
        FrameInput input = input_();
        input.settings.cut = true;
        const auto frameStart = Clock::now();
        const uint64_t allocations = allocationCount();
        const auto ticket = renderer.renderOffscreen(
            input, options_.size.x, options_.size.y,
            linear ? CaptureKind::hdr : CaptureKind::display, options);
        if (!ticket) return tl::unexpected(ticket.error());
        times_.allocations = allocationCount() - allocations;
        if (counts.rendered == 0 || frame + 1 == end) renderer.finish();  // what is timed is whole
        times_.wallMs = secondsSince(frameStart) * 1000;
        if (counts.rendered == 0) firstFrameMs_ = times_.wallMs;
        drawn(renderer.report());
        // While the GPU draws this frame the one before it comes back and is written.
        if (auto fetched = fetch(); !fetched) return tl::unexpected(fetched.error());
        pending = {*ticket, std::move(*path)};
        ++counts.rendered;
        progress.show(counts.rendered + counts.kept, end - begin, counts.kept);
    }
    if (auto fetched = fetch(); !fetched) return tl::unexpected(fetched.error());
    if (auto written = writer.finish(); !written) return tl::unexpected(written.error());
    counts.seconds = secondsSince(start);
    counts.writerWaits = writer.waits();
    return counts;
}

}  // namespace rushlight::tool

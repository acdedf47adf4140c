#pragma once
// The frames that were handed to the device: their commands until they are executed, what executing
// them gave after.

#include "renderer/frame/frame_report.h"
#include "renderer/rhi/device.h"

#include <chrono>
#include <utility>

namespace rushlight {

struct SubmittedFrame {
    uint64_t frameNumber = 0;
    std::chrono::steady_clock::time_point began;  ///< render()
    CommandBuffer commands;
    std::vector<PassReport> passes;  ///< what is known before it is executed
    std::vector<PassReport> sparePasses;
    ExecutionReport execution;
};

/// A ring. Its memory is kept: no allocation once each slot has held a frame like those to come.
class SubmittedFrames {
public:
    /// `maxPending`: Device::maxPendingFrames().
    explicit SubmittedFrames(uint32_t maxPending) : ring_(size_t(maxPending) + 1) {}

    /// The slot for a frame that is about to be executed, in the place of the oldest. Takes the
    /// commands; `commands` becomes one to fill again.
    SubmittedFrame& add(CommandBuffer& commands) {
        SubmittedFrame& frame = ring_[count_++ % ring_.size()];
        std::swap(frame.commands, commands);
        return frame;
    }

    const CommandBuffer& newestCommands() const {
        return ring_[(count_ + ring_.size() - 1) % ring_.size()].commands;
    }

    /// The newest that is executed, when the device still has `pending`; null before the first is.
    const SubmittedFrame* newestExecuted(uint32_t pending) const {
        return count_ > pending ? &ring_[(count_ - pending - 1) % ring_.size()] : nullptr;
    }

private:
    std::vector<SubmittedFrame> ring_;
    uint64_t count_ = 0;
};

}  // namespace rushlight

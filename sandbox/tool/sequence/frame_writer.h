#pragma once
// Pictures into files, behind the frames that are drawn.

#include "engine/core/result.h"
#include "renderer/capture/image_files.h"
#include "renderer/renderer.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace rushlight::tool {

/// Encodes and writes on a thread of its own, in order. A picture is in its file wholly or not at
/// all.
class FrameWriter {
public:
    /// At most `mostWaiting` pictures are kept in memory besides the one that is being written.
    FrameWriter(size_t mostWaiting, EncodeEffort effort);
    /// What waits is written.
    ~FrameWriter();
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    /// Returns at once unless as many wait as may. Takes `image` and leaves one that was written,
    /// for its memory. `description` goes into the file, for readDescription. The Error is that of
    /// an earlier picture; after it nothing is written any more.
    Result<void> write(std::string path, CapturedImage& image, std::string description);
    /// Returns when all is written.
    Result<void> finish();

    /// Calls of write() that had to wait.
    uint32_t waits() const { return waits_; }

private:
    struct Job {
        std::string path, description;
        CapturedImage image;
    };
    void run();

    const size_t mostWaiting_;
    const EncodeEffort effort_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> jobs_;
    std::vector<CapturedImage> spare_;
    Result<void> status_;
    bool writing_ = false, ends_ = false;
    uint32_t waits_ = 0;
    std::thread thread_;  // last: it uses the others
};

}  // namespace rushlight::tool

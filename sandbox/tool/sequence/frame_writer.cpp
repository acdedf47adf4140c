#include "sandbox/tool/sequence/frame_writer.h"

#ifdef __linux__
#include <pthread.h>
#endif

namespace rushlight::tool {

FrameWriter::FrameWriter(size_t mostWaiting, EncodeEffort effort)
    : mostWaiting_(mostWaiting), effort_(effort), thread_([this] { run(); }) {}

FrameWriter::~FrameWriter() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

Result<void> FrameWriter::write(std::string path, CapturedImage& image, std::string description) {
    std::unique_lock lock(mutex_);
    if (jobs_.size() >= mostWaiting_) {
        ++waits_;
        changed_.wait(lock, [&] { return jobs_.size() < mostWaiting_; });
    }
    if (!status_) return status_;
    jobs_.push_back({std::move(path), std::move(description), std::move(image)});
    image = {};
    if (!spare_.empty()) {
        image = std::move(spare_.back());
        spare_.pop_back();
    }
    changed_.notify_all();
    return {};
}

Result<void> FrameWriter::finish() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return jobs_.empty() && !writing_; });
    return status_;
}

void FrameWriter::run() {
#ifdef __linux__
    pthread_setname_np(pthread_self(), "frame writer");
#endif
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return ends_ || !jobs_.empty(); });
        if (jobs_.empty()) return;
        Job job = std::move(jobs_.front());
        jobs_.pop_front();
        writing_ = true;
        const bool failed = !status_;
        lock.unlock();
        changed_.notify_all();
        Result<void> saved;
        if (!failed) {
            PictureView view(job.image);
            view.description = job.description;
            saved = saveImage(job.path, view, effort_);
        }
        lock.lock();
        writing_ = false;
        spare_.push_back(std::move(job.image));
        if (!saved) status_ = saved;
        changed_.notify_all();
    }
}

}  // namespace rushlight::tool

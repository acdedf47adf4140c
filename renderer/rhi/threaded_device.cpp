#include "renderer/rhi/threaded_device.h"

#include "engine/core/check.h"

#include <utility>

namespace rushlight {
namespace {

tl::unexpected<Error> wrongUse(const char* message) {
    return fail("renderer", message, ErrorKind::wrongUse);
}

}  // namespace

ThreadedDevice::ThreadedDevice(std::unique_ptr<Device> device, uint32_t frames)
    : device_(std::move(device)), maxPending_(frames) {
    RL_CHECK(frames > 0, "at least one frame is in flight");
    // Twice what waits, before push() moves it to the front: however late the serving thread is, a
    // warm frame allocates nothing.
    constexpr size_t kOtherJobs = 16;
    jobs_.reserve(2 * (frames + kOtherJobs));
}

// ---- the serving thread
// ------------------------------------------------------------------------------------------

Result<void> ThreadedDevice::serve(void (*afterFrame)(void* user), void* user) {
    Lock lock(mutex_);
    if (serving_) return wrongUse("a thread serves it already.");
    if (entered_) return wrongUse("serve() is called while the renderer is in use.");
    serving_ = true;
    ++sessions_;
    owner_ = std::this_thread::get_id();
    toCaller_.notify_all();
    serveJobs(lock, afterFrame, user);
    serving_ = stopping_ = false;
    toCaller_.notify_all();
    return {};
}

void ThreadedDevice::serveJobs(Lock& lock, void (*afterFrame)(void* user), void* user) {
    for (;;) {
        const std::optional<Job> job = pop();
        if (!job) {
            if (stopping_ && !entered_) return;
            toServer_.wait(lock);
            continue;
        }
        lock.unlock();
        run(*job);
        if (job->frame && job->options.toHost && afterFrame) afterFrame(user);
        Result<void> status = device_->status(), failure = device_->takeFailure();
        lock.lock();
        if (!status) status_ = std::move(status);
        if (!failure && failure_) failure_ = std::move(failure);
        if (job->frame) --pending_;
        if (job->call) job->call->done = true;
        if (job->frame || job->call) toCaller_.notify_all();
    }
}

void ThreadedDevice::run(const Job& job) {
    if (job.frame)
        device_->execute(*job.frame, job.options, *job.report);
    else if (job.call)
        job.call->run(job.call->closure);
    else if (job.buffer)
        device_->destroy(job.buffer);
    else
        device_->destroy(job.texture);
}

std::optional<ThreadedDevice::Job> ThreadedDevice::pop() {
    if (firstJob_ == jobs_.size()) return {};
    const Job job = jobs_[firstJob_++];
    if (firstJob_ == jobs_.size()) {
        jobs_.clear();
        firstJob_ = 0;
    }
    return job;
}

// ---- the others
// --------------------------------------------------------------------------------------------------

void ThreadedDevice::stopServing() {
    Lock lock(mutex_);
    stopping_ = true;
    toServer_.notify_all();
    toCaller_.notify_all();  // who waits for the first serve()
    if (owner_ == std::this_thread::get_id()) return;
    toCaller_.wait(lock, [&, session = sessions_] { return !serving_ || sessions_ != session; });
}

Result<void> ThreadedDevice::enter() {
    Lock lock(mutex_);
    const auto self = std::this_thread::get_id();
    if (self != owner_ && sessions_ == 0)
        toCaller_.wait(lock, [&] { return sessions_ > 0 || stopping_; });
    if (entered_) return wrongUse("two threads use it at the same time.");
    if (serving_ && self == owner_)
        return wrongUse("it is used on the thread that serves it; use it on another one.");
    if (self != owner_ && (!serving_ || stopping_))
        return wrongUse(
            "no thread serves it any more; call serve() again, or use it on the thread "
            "on which its context is current.");
    entered_ = true;
    return {};
}

void ThreadedDevice::leave() {
    const Lock lock(mutex_);
    entered_ = false;
    if (stopping_) toServer_.notify_all();
}

bool ThreadedDevice::hasServer() const {
    const Lock lock(mutex_);
    return serving_ && owner_ != std::this_thread::get_id();
}

void ThreadedDevice::push(const Job& job, bool ahead) {
    if (ahead && firstJob_ > 0) {
        jobs_[--firstJob_] = job;
    } else if (ahead) {
        jobs_.insert(jobs_.begin(), job);
    } else {
        if (firstJob_ > jobs_.size() / 2) {
            jobs_.erase(jobs_.begin(), jobs_.begin() + std::ptrdiff_t(firstJob_));
            firstJob_ = 0;
        }
        jobs_.push_back(job);
    }
    toServer_.notify_all();
}

void ThreadedDevice::waitFor(Call& call, bool ahead) {
    Lock lock(mutex_);
    ++synchronousCalls_;
    push({.call = &call}, ahead);
    toCaller_.wait(lock, [&] { return call.done; });
}

void ThreadedDevice::destroy(BufferHandle buffer) {
    if (!hasServer()) return device_->destroy(buffer);
    const Lock lock(mutex_);
    if (buffer) push({.buffer = buffer});
}

void ThreadedDevice::destroy(TextureHandle texture) {
    if (!hasServer()) return device_->destroy(texture);
    const Lock lock(mutex_);
    if (texture) push({.texture = texture});
}

void ThreadedDevice::execute(const CommandBuffer& commands, const ExecuteOptions& options,
                             ExecutionReport& report) {
    report.queueWaits = 0;
    report.synchronousCalls = 0;
    if (!hasServer()) return device_->execute(commands, options, report);
    Lock lock(mutex_);
    report.synchronousCalls = std::exchange(synchronousCalls_, 0);
    if (pending_ == maxPending_) {
        ++report.queueWaits;
        toCaller_.wait(lock, [&] { return pending_ < maxPending_; });
    }
    ++pending_;
    push({.frame = &commands, .options = options, .report = &report});
}

uint32_t ThreadedDevice::pendingFrames() const {
    const Lock lock(mutex_);
    return pending_;
}

Result<void> ThreadedDevice::takeFailure() {
    {
        const Lock lock(mutex_);
        if (!failure_) return std::exchange(failure_, {});
    }
    return hasServer() ? Result<void>() : device_->takeFailure();
}

Result<void> ThreadedDevice::status() const {
    if (!hasServer()) return device_->status();
    const Lock lock(mutex_);
    return status_;
}

}  // namespace rushlight

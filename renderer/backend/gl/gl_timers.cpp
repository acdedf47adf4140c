#include "renderer/backend/gl/gl_timers.h"

#include "engine/core/hash.h"

#include <algorithm>

namespace rushlight {
namespace {

GLint64 nanoseconds(GlTimers::Clock::time_point time) {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count();
}

}  // namespace

GlTimers::~GlTimers() {
    for (const Frame& frame : frames_)
        for (const Pass& pass : frame.passes) {
            const GLuint queries[] = {pass.begin, pass.end};
            gl_.DeleteQueries(2, queries);
        }
}

void GlTimers::compareClocks() {
    if (untilCompared_-- > 0) return;
    untilCompared_ = 63;
    GLint64 now = 0;
    gl_.GetInteger64v(GL_TIMESTAMP, &now);
    gpuAhead_ = now - nanoseconds(Clock::now());
}

void GlTimers::beginFrame(bool enabled, uint64_t number, Clock::time_point began) {
    // Oldest first, so the newest that is finished has the last word.
    for (uint32_t i = 0; i < kFrames; ++i) collect(frames_[(next_ + i) % kFrames]);
    open_ = nullptr;
    if (!enabled || frames_[next_].pending) return;
    open_ = &frames_[next_];
    open_->used = 0;
    open_->number = number;
    open_->began = nanoseconds(began) + gpuAhead_;
}

GLuint GlTimers::createQuery(std::string_view label) const {
    GLuint query = 0;
    gl_.CreateQueries(GL_TIMESTAMP, 1, &query);
    gl_.label(GL_QUERY, query, label);
    return query;
}

void GlTimers::beginPass(std::string_view name) {
    if (!open_) return;
    if (open_->used == open_->passes.size())
        open_->passes.push_back({createQuery("pass begins"), createQuery("pass ends"), 0});
    Pass& pass = open_->passes[open_->used++];
    pass.name = hashText(name);
    gl_.QueryCounter(pass.begin, GL_TIMESTAMP);
}

void GlTimers::endPass() {
    if (open_ && open_->used > 0)
        gl_.QueryCounter(open_->passes[open_->used - 1].end, GL_TIMESTAMP);
}

void GlTimers::endFrame() {
    if (!open_) return;
    open_->pending = open_->used > 0;
    if (open_->pending) next_ = (next_ + 1) % kFrames;
    open_ = nullptr;
}

void GlTimers::collect(Frame& frame) {
    if (!frame.pending) return;
    GLint available = GL_FALSE;
    gl_.GetQueryObjectiv(frame.passes[frame.used - 1].end, GL_QUERY_RESULT_AVAILABLE, &available);
    if (!available) return;
    frame.pending = false;
    newest_.clear();
    newestFrame_ = frame.number;
    for (uint32_t i = 0; i < frame.used; ++i) {
        const Pass& pass = frame.passes[i];
        GLuint64 begin = 0, end = 0;
        gl_.GetQueryObjectui64v(pass.begin, GL_QUERY_RESULT, &begin);
        gl_.GetQueryObjectui64v(pass.end, GL_QUERY_RESULT, &end);
        const Time time = {double(GLint64(begin) - frame.began) * 1e-6,
                           end > begin ? double(end - begin) * 1e-6 : 0};
        newest_.push_back({pass.name, time});
    }
}

GlTimers::Time GlTimers::newest(uint32_t index, std::string_view name) const {
    const uint64_t wanted = hashText(name);
    if (index < newest_.size() && newest_[index].name == wanted) return newest_[index].time;
    const auto found = std::ranges::find(newest_, wanted, &PassTime::name);
    return found != newest_.end() ? found->time : Time();
}

}  // namespace rushlight

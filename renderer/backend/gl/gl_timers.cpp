#include "renderer/backend/gl/gl_timers.h"

#include <algorithm>

namespace rushlight {

GlTimers::~GlTimers() {
    for (const Frame& frame : frames_)
        gl_.DeleteQueries(GLsizei(frame.queries.size()), frame.queries.data());
}

void GlTimers::beginFrame(bool enabled) {
    // Oldest first, so the newest that is finished has the last word.
    for (uint32_t i = 0; i < kFrames; ++i) collect(frames_[(next_ + i) % kFrames]);
    open_ = nullptr;
    if (!enabled || frames_[next_].pending) return;
    open_ = &frames_[next_];
    open_->last = 0;
    std::ranges::fill(open_->marked, uint8_t(0));
}

void GlTimers::mark(uint32_t index) {
    if (!open_) return;
    while (open_->queries.size() <= index) {
        open_->queries.push_back(0);
        open_->marked.push_back(0);
        gl_.CreateQueries(GL_TIMESTAMP, 1, &open_->queries.back());
        gl_.label(GL_QUERY, open_->queries.back(),
                  open_->queries.size() % 2 ? "pass begins" : "pass ends");
    }
    open_->marked[index] = 1;
    open_->last = open_->queries[index];
    gl_.QueryCounter(open_->last, GL_TIMESTAMP);
}

void GlTimers::endFrame() {
    if (!open_) return;
    open_->pending = open_->last != 0;
    if (open_->pending) next_ = (next_ + 1) % kFrames;
    open_ = nullptr;
}

void GlTimers::collect(Frame& frame) {
    if (!frame.pending) return;
    GLint available = GL_FALSE;
    gl_.GetQueryObjectiv(frame.last, GL_QUERY_RESULT_AVAILABLE, &available);
    if (!available) return;
    frame.pending = false;
    latest_.assign(frame.queries.size() / 2, 0.0);
    for (size_t pass = 0; pass < latest_.size(); ++pass) {
        if (!frame.marked[pass * 2] || !frame.marked[pass * 2 + 1]) continue;
        GLuint64 times[2] = {};
        for (size_t i = 0; i < 2; ++i)
            gl_.GetQueryObjectui64v(frame.queries[pass * 2 + i], GL_QUERY_RESULT, &times[i]);
        latest_[pass] = times[1] > times[0] ? double(times[1] - times[0]) * 1e-6 : 0;
    }
}

}  // namespace rushlight

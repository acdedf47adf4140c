#include "renderer/backend/gl/gl_timers.h"

#include "engine/core/hash.h"

#include <algorithm>

namespace rushlight {

GlTimers::~GlTimers() {
    for (const Frame& frame : frames_)
        for (const Pass& pass : frame.passes) {
            const GLuint queries[] = {pass.begin, pass.end};
            gl_.DeleteQueries(2, queries);
        }
}

void GlTimers::beginFrame(bool enabled) {
    // Oldest first, so the newest that is finished has the last word.
    for (uint32_t i = 0; i < kFrames; ++i) collect(frames_[(next_ + i) % kFrames]);
    open_ = nullptr;
    if (!enabled || frames_[next_].pending) return;
    open_ = &frames_[next_];
    open_->used = 0;
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
    if (open_ && open_->used > 0) gl_.QueryCounter(open_->passes[open_->used - 1].end, GL_TIMESTAMP);
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
    latest_.clear();
    for (uint32_t i = 0; i < frame.used; ++i) {
        const Pass& pass = frame.passes[i];
        GLuint64 begin = 0, end = 0;
        gl_.GetQueryObjectui64v(pass.begin, GL_QUERY_RESULT, &begin);
        gl_.GetQueryObjectui64v(pass.end, GL_QUERY_RESULT, &end);
        latest_.push_back({pass.name, end > begin ? double(end - begin) * 1e-6 : 0});
    }
}

double GlTimers::milliseconds(uint32_t index, std::string_view name) const {
    const uint64_t wanted = hashText(name);
    if (index < latest_.size() && latest_[index].name == wanted) return latest_[index].milliseconds;
    const auto found = std::ranges::find(latest_, wanted, &Time::name);
    return found != latest_.end() ? found->milliseconds : 0;
}

}  // namespace rushlight

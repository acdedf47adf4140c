#pragma once
// What each pass costs the GPU, from timestamps; they nest in whatever timer query the host may have open.

#include "renderer/backend/gl/gl_functions.h"

#include <array>
#include <vector>

namespace rushlight {

class GlTimers {
public:
    explicit GlTimers(const GlFunctions& gl) : gl_(gl) {}
    ~GlTimers();

    /// Collects the results that are there, then opens a frame. Never waits: while every frame of the ring is still
    /// with the GPU, the frame is not timed.
    void beginFrame(bool enabled);
    void beginPass(uint32_t pass) { mark(pass * 2); }
    void endPass(uint32_t pass) { mark(pass * 2 + 1); }
    void endFrame();

    /// Milliseconds in the newest finished frame.
    double milliseconds(uint32_t pass) const {
        return pass < latest_.size() ? latest_[pass] : 0;
    }

private:
    static constexpr uint32_t kFrames = 4;
    struct Frame {
        std::vector<GLuint> queries;  ///< two a pass
        std::vector<uint8_t> marked;
        GLuint last = 0;              ///< the query that was issued last
        bool pending = false;
    };
    void mark(uint32_t index);
    void collect(Frame& frame);

    const GlFunctions& gl_;
    std::array<Frame, kFrames> frames_;
    uint32_t next_ = 0;
    Frame* open_ = nullptr;
    std::vector<double> latest_;
};

}  // namespace rushlight

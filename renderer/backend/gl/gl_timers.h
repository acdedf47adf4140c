#pragma once
// What each pass costs the GPU, from timestamps; they nest in whatever timer query the host may have open.

#include "renderer/backend/gl/gl_functions.h"

#include <array>
#include <string_view>
#include <vector>

namespace rushlight {

class GlTimers {
public:
    explicit GlTimers(const GlFunctions& gl) : gl_(gl) {}
    ~GlTimers();

    /// Collects the results that are there, then opens a frame. Never waits: while every frame of the ring is still
    /// with the GPU, the frame is not timed.
    void beginFrame(bool enabled);
    void beginPass(std::string_view name);
    void endPass();
    void endFrame();

    /// Milliseconds in the newest finished frame, of its pass of this index if it has this name, else of its first pass
    /// that has; 0 without one.
    double milliseconds(uint32_t index, std::string_view name) const;

private:
    static constexpr uint32_t kFrames = 4;
    struct Pass {
        GLuint begin = 0, end = 0;  ///< queries
        uint64_t name = 0;          ///< hash
    };
    struct Frame {
        std::vector<Pass> passes;  ///< of this frame are the first `used`
        uint32_t used = 0;
        bool pending = false;
    };
    struct Time {
        uint64_t name;
        double milliseconds;
    };
    GLuint createQuery(std::string_view label) const;
    void collect(Frame& frame);

    const GlFunctions& gl_;
    std::array<Frame, kFrames> frames_;
    uint32_t next_ = 0;
    Frame* open_ = nullptr;
    std::vector<Time> latest_;
};

}  // namespace rushlight
